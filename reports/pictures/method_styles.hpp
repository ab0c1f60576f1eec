#pragma once

#include "reports/pictures/pictures.hpp"
#include "reports/text/json_values.hpp"
#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// How a method is drawn in every picture of a report.
struct MethodStyle {
    std::string method;
    std::string colour;
    std::string symbol;
    bool in_colour = true;  ///< otherwise grey
};

/// One for each method, in the order of the study. With more than seven, colours go to the ones that a publication
/// compares, the random reference, the three best-ranked and the user's own, as long as there are colours.
std::vector<MethodStyle> method_styles(const studies::StudyResults& results, const MethodChoice& choice = {});

/// The scales "color" and "shape" of a picture, for Picture::values.
Json style_scales(const std::vector<MethodStyle>& styles);

}  // namespace ff::reports

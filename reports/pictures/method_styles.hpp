#pragma once

#include "reports/pictures/method_choice.hpp"
#include "studies/results/results.hpp"

#include <nlohmann/json_fwd.hpp>

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

/// One for each method, in the order of the study. Of more than seven only the random reference, the three with the
/// best ranks and those that a publication compares are in colour; of chosen methods all are, as far as colours go.
std::vector<MethodStyle> method_styles(const studies::StudyResults& results, const MethodChoice& methods = {});

/// The scales "color" and "shape" of a picture, for Picture::values.
nlohmann::ordered_json style_scales(const std::vector<MethodStyle>& styles);

}  // namespace ff::reports

#pragma once

#include "reports/pictures/pictures.hpp"
#include "reports/templates/templates.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// How a figure is drawn on paper. Lines and symbols scale with the font size.
struct FigureStyle {
    double width = 0;              ///< mm
    std::optional<double> height;  ///< mm; empty: the default of its kind
    double font_size = 8;          ///< points
    std::string font;              ///< a font family; empty: the one of reports
};

/// Every picture of a report, each once.
std::vector<Picture> all_pictures(const studies::StudyResults& results, const MethodChoice& methods = {});

/// The input of draw_svg.mjs for these pictures: JSON of `kinds` (specifications by name), `pictures` (`id`, `kind`,
/// `values`) and, of figures, `style`.
std::string drawing_request(const std::vector<Picture>& pictures, const Templates& templates,
                            const std::optional<FigureStyle>& style = std::nullopt);

}  // namespace ff::reports

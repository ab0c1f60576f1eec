#pragma once

#include "reports/pictures/pictures.hpp"

#include <optional>
#include <string>

namespace ff::reports {

/// The picture beside the answer in report.md: that of report.html where it can be drawn without a script, otherwise
/// the ranking of the methods that the answer compares; empty where there is neither.
std::optional<Picture> answer_picture(const studies::StudyResults& results);

/// Such a picture as an SVG.
std::string answer_svg(const Picture& picture);

/// A row for each method with its value, interval, group, and tick of what was expected.
/// @pre the picture is of kind "ranking"
std::string ranking_svg(const Picture& picture);

/// Whether `lines_svg` draws pictures of this kind: error against evaluations, the occluded fraction or reflectance.
bool has_lines_svg(const Picture& picture);

/// A line for each method, with labels at the ends. @pre has_lines_svg
std::string lines_svg(const Picture& picture);

/// Which method to take for each kind of pairs (rows) in how much processor time (columns), which differs from run to
/// run; empty where the study does not ask: it has one scene, or is about occlusion.
std::optional<std::string> decisions_svg(const studies::StudyResults& results);

}  // namespace ff::reports

#pragma once

#include "reports/pictures/pictures.hpp"

#include <string>

namespace ff::reports {

/// The picture beside the answer as an SVG for report.md, which cannot run a script to draw it: a row for each method
/// with its value, interval, group, and tick of what was expected.
/// @pre the picture is of kind "ranking"
std::string ranking_svg(const Picture& picture);

}  // namespace ff::reports

#pragma once

#include "core/geometry/fwd.hpp"

#include <string>

namespace ff::reports {

/// A line drawing of a scene as an SVG element, in parallel projection with z upwards: flat surfaces as outlines, round
/// ones as rings and the lines between them, labels in the middle of each face's largest surface, obstacles dashed.
/// Colours are those of the surrounding text. With more than 2000 surfaces only a subset is drawn.
std::string scene_drawing(const Scene& scene);

}  // namespace ff::reports

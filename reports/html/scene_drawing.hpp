#pragma once

#include "core/geometry/scene.hpp"

#include <string>

namespace ff::reports {

/// A line drawing of a scene as an SVG element, in parallel projection with z upwards: flat surfaces as outlines, round
/// ones as rings and the lines between them, labels in the middle of each face's largest surface, what is no face
/// dashed. Colours are those of the text around it. Of more than 2000 surfaces every so many are drawn.
std::string scene_drawing(const Scene& scene);

}  // namespace ff::reports

#pragma once

#include "core/scene.hpp"

#include <string_view>

namespace ff {

/// The inside of the box [0,a] x [0,b] x [0,c] with the paper's face numbers: 1 (z = 0) opposite 6 (z = c), both a x b;
/// 2 (y = b) opposite 3 (y = 0, frontal), both a x c; 4 (x = 0) opposite 5 (x = a), both b x c. The labels are
/// "1".."6", face index i has label i + 1, and surface i is face i. Edges point along the positive axes; normals point
/// inward.
/// Scenes of equal edges have equal `canonical` texts, down to the last bit of each number.
/// @throws UserError unless all edges are finite, positive and within 1e-70 to 1e70 (areas squared must be numbers too)
Scene make_box(double a, double b, double c);

/// A built-in scene by name: "cube" (the paper's, a = b = c = 6), "box:AxBxC", e.g. "box:2x1x0.5", a scene of the
/// catalogue, or one of its families, e.g. "squares_blocked:0.25".
/// @throws UserError with the known names otherwise
Scene built_in_scene(std::string_view name);

}  // namespace ff

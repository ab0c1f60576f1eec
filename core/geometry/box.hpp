#pragma once

#include "core/geometry/fwd.hpp"

namespace ff {

/// The inside of the box [0,a] x [0,b] x [0,c] with the paper's face numbers: 1 (z = 0) opposite 6 (z = c), both a x b;
/// 2 (y = b) opposite 3 (y = 0, frontal), both a x c; 4 (x = 0) opposite 5 (x = a), both b x c. The labels are
/// "1".."6", face index i has label i + 1, and surface i is face i. Edges point along the positive axes; normals point
/// inward.
/// Scenes of equal edges have equal `canonical` texts, down to the last bit of each number.
/// @throws UserError unless all edges are finite, positive and within 1e-70 to 1e70 (areas squared must be numbers too)
Scene make_box(double a, double b, double c);

}  // namespace ff

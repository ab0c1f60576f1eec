#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ff {

/// Divides a polygon that need not be convex, nor quite plane, into triangles, by cutting off one corner after another
/// that no other corner lies in the way of [meisters1975]. Of a convex quadrilateral, the shorter diagonal is taken.
/// @return numbers of the corners of each, counter-clockwise as the polygon is around the mean of its normal, without
/// those that have no area; none where edges of the polygon cross each other
std::vector<std::array<std::size_t, 3>> clip_ears(const std::vector<Eigen::Vector3d>& corners);

}  // namespace ff

#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ff {

/// Divides a polygon that need not be convex, nor quite plane, into triangles: it cuts off corners, one after another,
/// where no other corner is in the way [meisters1975]. A convex quadrilateral is cut along its shorter diagonal.
/// @return numbers of the corners of each, counter-clockwise as the polygon is around the mean of its normal, without
/// those that have no area; none where edges of the polygon cross each other
std::vector<std::array<std::size_t, 3>> clip_ears(const std::vector<Eigen::Vector3d>& corners);

/// An outline without the corners at which it turns back along itself: nothing lies between there and back. At least
/// three corners are left.
std::vector<Eigen::Vector3d> without_spikes(std::vector<Eigen::Vector3d> corners);

}  // namespace ff

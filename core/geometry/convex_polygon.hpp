#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Geometry>

#include <cstddef>
#include <span>
#include <vector>

namespace ff {

/// Corners of a plane convex polygon, in order around it.
using ConvexPolygon = std::vector<Eigen::Vector3d>;

/// The corners of a surface, counter-clockwise as seen from the side that its normal points to; none of a round one.
ConvexPolygon outline(const Surface& surface);

/// The element that belongs to the corner after the k-th one, in order around a polygon.
template <class Around>
const typename Around::value_type& next_corner(const Around& around, std::size_t k) {
    return around[k + 1 == around.size() ? 0 : k + 1];
}

/// Twice the area of a plane polygon, along the normal that its corners are counter-clockwise around.
template <class AnyPolygon>
typename AnyPolygon::value_type twice_area(const AnyPolygon& polygon) {
    typename AnyPolygon::value_type sum = AnyPolygon::value_type::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        sum += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
    return sum;
}

/// Area of a polygon, in squared units of length.
template <class AnyPolygon>
auto polygon_area(const AnyPolygon& polygon) {
    return twice_area(polygon).norm() / 2;
}

/// The axis-aligned box around places.
Eigen::AlignedBox3d box_around(std::span<const Eigen::Vector3d> places);

/// Reverses the corners where that makes them counter-clockwise around a normal.
void turn_around(ConvexPolygon& polygon, const Eigen::Vector3d& normal);

/// Distance of a place from the straight line from a to b.
double distance(const Eigen::Vector3d& place, const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Distance of a place from a polygon.
/// @param normal  of any length, for corners that are counter-clockwise around it
double distance(const Eigen::Vector3d& place, const ConvexPolygon& polygon, const Eigen::Vector3d& normal);

/// The part of a convex polygon on one side of a plane, rim included; empty where there is none.
/// @param height  of a corner above the plane, in any unit; negative on the other side
template <class AnyPolygon, class Height>
AnyPolygon part_above(const AnyPolygon& polygon, const Height& height) {
    AnyPolygon part;
    if (polygon.empty()) return part;
    auto after = height(polygon.front());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto& a = polygon[k];
        const auto& b = next_corner(polygon, k);
        const auto before = after;
        after = height(b);
        if (before >= 0) part.push_back(a);
        if ((before > 0 && after < 0) || (before < 0 && after > 0))
            part.push_back(a + (b - a) * (before / (before - after)));
    }
    if (part.size() < 3) part.clear();
    return part;
}

/// The part of a convex polygon where normal * v >= offset; empty where there is none.
ConvexPolygon clipped(const ConvexPolygon& polygon, const Eigen::Vector3d& normal, double offset);

double length_around(const ConvexPolygon& polygon);

/// Whether a polygon is only a sliver that rounding leaves along an edge. @param gap  lines nearer than this are one
bool is_sliver(const ConvexPolygon& polygon, double gap);

/// The part that a polygon has in common with a convex one, both counter-clockwise around this normal of their plane.
ConvexPolygon common_part(ConvexPolygon part, const ConvexPolygon& polygon, const Eigen::Vector3d& normal);

/// Convex pieces without their overlap with a convex polygon that is counter-clockwise around their normal, again
/// convex. @param gap  lines nearer than this are one
std::vector<ConvexPolygon> without(const std::vector<ConvexPolygon>& pieces, const ConvexPolygon& polygon,
                                   const Eigen::Vector3d& normal, double gap);

}  // namespace ff

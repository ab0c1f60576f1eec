#include "core/geometry/convex_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff {

using Eigen::Vector3d;

ConvexPolygon outline(const Surface& surface) {
    ConvexPolygon polygon = corners(surface.shape);
    turn_around(polygon, surface.normal);
    return polygon;
}

Eigen::AlignedBox3d box_around(std::span<const Vector3d> places) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& place : places) box.extend(place);
    return box;
}

void turn_around(ConvexPolygon& polygon, const Vector3d& normal) {
    if (twice_area(polygon).dot(normal) < 0) std::reverse(polygon.begin(), polygon.end());
}

double distance(const Vector3d& place, const Vector3d& a, const Vector3d& b) {
    const Vector3d edge = b - a;
    const Vector3d offset = place - a;
    const double squared = edge.squaredNorm();
    const double along = squared > 0 ? std::clamp(offset.dot(edge) / squared, 0.0, 1.0) : 0;
    return (offset - along * edge).norm();
}

double distance(const Vector3d& place, const ConvexPolygon& polygon, const Vector3d& normal) {
    bool inside = normal.squaredNorm() > 0;
    for (std::size_t k = 0; inside && k < polygon.size(); ++k)
        inside = normal.cross(next_corner(polygon, k) - polygon[k]).dot(place - polygon[k]) >= 0;
    if (inside) return std::abs(normal.normalized().dot(place - polygon.front()));
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < polygon.size(); ++k)
        nearest = std::min(nearest, distance(place, polygon[k], next_corner(polygon, k)));
    return nearest;
}

ConvexPolygon clipped(const ConvexPolygon& polygon, const Vector3d& normal, double offset) {
    return part_above(polygon, [&](const Vector3d& corner) { return normal.dot(corner) - offset; });
}

}  // namespace ff

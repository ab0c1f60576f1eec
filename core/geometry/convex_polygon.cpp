#include "core/geometry/convex_polygon.hpp"

#include "core/geometry/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

namespace {

/// The polygon without corners that coincide with another, or lie on the line between their neighbours, up to rounding.
ConvexPolygon cleaned(ConvexPolygon polygon, double gap) {
    for (std::size_t k = 0; k < polygon.size() && polygon.size() >= 3;) {
        const std::size_t n = polygon.size();
        const Vector3d& before = polygon[(k + n - 1) % n];
        const Vector3d& after = polygon[(k + 1) % n];
        if (distance(polygon[k], before, after) > gap) {
            ++k;
        } else {
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
            k = k > 0 ? k - 1 : 0;
        }
    }
    return polygon;
}

/// The part of a polygon on one side of an edge of another, both in a plane with this normal.
ConvexPolygon beside_edge(const ConvexPolygon& polygon, const Vector3d& a, const Vector3d& b, const Vector3d& normal,
                          double side) {
    const Vector3d inwards = side * normal.cross(b - a).normalized();
    return clipped(polygon, inwards, inwards.dot(a));
}

}  // namespace

double length_around(const ConvexPolygon& polygon) {
    double length = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) length += (next_corner(polygon, k) - polygon[k]).norm();
    return length;
}

bool is_sliver(const ConvexPolygon& polygon, double gap) {
    return polygon_area(polygon) <= gap * length_around(polygon);
}

ConvexPolygon common_part(ConvexPolygon part, const ConvexPolygon& polygon, const Vector3d& normal) {
    for (std::size_t k = 0; k < polygon.size() && part.size() >= 3; ++k)
        part = beside_edge(part, polygon[k], next_corner(polygon, k), normal, 1);
    return part;
}

std::vector<ConvexPolygon> without(const std::vector<ConvexPolygon>& pieces, const ConvexPolygon& polygon,
                                   const Vector3d& normal, double gap) {
    std::vector<ConvexPolygon> left;
    for (const ConvexPolygon& piece : pieces) {
        if (is_sliver(common_part(piece, polygon, normal), gap)) {
            left.push_back(piece);
            continue;
        }
        ConvexPolygon rest = piece;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vector3d& a = polygon[k];
            const Vector3d& b = next_corner(polygon, k);
            ConvexPolygon outside = beside_edge(rest, a, b, normal, -1);
            if (!is_sliver(outside, gap)) left.push_back(cleaned(std::move(outside), gap));
            rest = beside_edge(rest, a, b, normal, 1);
        }
    }
    return left;
}

}  // namespace ff

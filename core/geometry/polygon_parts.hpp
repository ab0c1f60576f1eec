#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <vector>

namespace ff {

double length_around(const ConvexPolygon& polygon);

/// Whether a polygon is what rounding leaves along an edge. @param gap  lines nearer than this are one
bool is_sliver(const ConvexPolygon& polygon, double gap);

/// The part of a polygon that a convex one has as well, both counter-clockwise around this normal of their plane.
ConvexPolygon common_part(ConvexPolygon part, const ConvexPolygon& polygon, const Eigen::Vector3d& normal);

/// What is left of convex pieces without a convex polygon that is counter-clockwise around their normal, in convex
/// pieces. @param gap  lines nearer than this are one
std::vector<ConvexPolygon> without(const std::vector<ConvexPolygon>& pieces, const ConvexPolygon& polygon,
                                   const Eigen::Vector3d& normal, double gap);

}  // namespace ff

#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace ff {

using LidPlane = Eigen::Hyperplane<double, 3>;

/// The plane polygons that close the rim of a body, one in each of these planes, in which its edges lie. They also have
/// places where three planes meet, as in a corner of a room, which the rim has not.
/// @param rim  corners in order; it need not be plane
/// @param gap  places nearer than this are one
/// @return none where they do not close it
std::vector<ConvexPolygon> closing_polygons(const ConvexPolygon& rim, const std::vector<LidPlane>& planes, double gap);

}  // namespace ff

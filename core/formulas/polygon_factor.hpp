#pragma once

#include "core/points/points.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ff {

/// The exact form factor from a differential area to a polygon (Lambert's formula): each edge contributes the angle
/// under which it is seen times the cosine between the normal and the plane through the edge and the point.
/// The differential area lies in the plane z = 0 and radiates upwards. @see [baum1989]

/// Vertices in order, counter-clockwise as seen from the side that receives.
using Polygon = std::vector<Eigen::Vector3d>;

/// The part of a convex polygon on or above the plane z = 0; fewer than three vertices where there is none.
Polygon clip_at_horizon(const Polygon& polygon);

/// Weighted points (x, y, 0). Padded with weights of 0 to a multiple of eight.
struct PlanePoints {
    using Component = std::array<double, block_capacity>;
    alignas(64) Component x, y, weight;
    std::size_t size = 0;  ///< multiple of 8
};

/// The sum over points of weight * form factor, dimensionless. A point behind the polygon sees nothing of it; for a
/// point on an edge the limit from the receiving side is taken. Within about 1e-16 per unit of weight, times the
/// polygon's extent over the point's distance from its edges. Terms are added in eight columns whatever the vector
/// length, so every CPU gives the same bits.
/// @pre no vertex lies below the plane
double sum_polygon_factors(const PlanePoints& points, const Polygon& polygon);

}  // namespace ff

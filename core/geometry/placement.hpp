#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

namespace ff {

/// How a scene is moved and scaled before it is computed with: a place x becomes (x - origin) / unit. Form factors do
/// not change, and coordinates keep the digits that single precision, sums and differences would lose.
struct Placement {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    double unit = 1;

    [[nodiscard]] bool is_identity() const { return unit == 1 && origin.isZero(0); }
};

/// Coordinates larger than so many times the longest edge of the box around a scene are far.
inline constexpr double far_off = 8;

/// Along each axis a scene is moved where some coordinate is far, to the middle of the box around it, rounded to a
/// multiple of its longest edge's power of two, so that no digit of a far coordinate is lost. It is scaled where that
/// edge is not between 2^-20 and 2^20, by a power of two. Other scenes stay as they are, to the bit.
Placement placement_of(const Scene& scene);

/// The largest absolute coordinate of a scene.
double farthest_coordinate(const Scene& scene);

/// The error that far coordinates, those along axes on which a scene is moved, may have because double precision
/// rounded them: half a unit in the last place of the largest. 0 where each is a multiple of 256 such units, as whole
/// numbers are: rounding would hardly leave them so.
double rounding_of_far_coordinates(const Scene& scene, const Placement& placement);

/// The scene in its place; its coordinate_rounding is at least that of its far coordinates. Placing it again changes
/// nothing.
Scene placed(const Scene& scene, const Placement& placement);
Scene placed(const Scene& scene);

}  // namespace ff

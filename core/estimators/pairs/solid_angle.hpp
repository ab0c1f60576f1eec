#pragma once

#include "core/estimators/entry.hpp"
#include "core/estimators/unmet.hpp"

#include <Eigen/Core>

#include <string>

namespace ff {

/// A rectangle as seen from the origin: corners (x, y) to (x + width, y + height) in a plane at a distance.
/// @pre width, height, distance > 0
struct SeenRectangle {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
    double distance = 0;
};

/// Half the solid angle, in steradians; 0 to pi. Keeps all digits where it is small. @see [vanoosterom1983]
double half_solid_angle(const SeenRectangle& seen);

/// The place at (s, t) in [0, 1]^2, from the corner, a map that keeps shares of solid angle: `s` moves a line along the
/// width, `t` leads along the line. Smooth in both, and the same bits on every CPU. @see [urena2013]
/// @param half_area  its half_solid_angle
Eigen::Vector2d place_in(const SeenRectangle& seen, double half_area, double s, double t);

/// A spherical triangle that directions are drawn from: unit vectors from the centre to its corners.
struct SphericalTriangle {
    Eigen::Vector3d a, b, c;
    double half_area = 0;  ///< half the solid angle, in steradians; 0 to pi
};

/// The spherical triangle that a plane triangle subtends.
/// @param a, b, c   from the centre to the corners; none of length 0
/// @param volume    |a . (b x c)|: its height times twice its area, which keeps all digits where it is small
SphericalTriangle spherical_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                     double volume);

/// The unit direction at (s, t) in [0, 1]^2, a map that preserves ratios of solid angle: `s` sweeps the arc from a to
/// c, `t` leads from b to it. Computed with half angles, which do not cancel where the triangle is small. The same bits
/// on every CPU. @see [arvo1995]
Eigen::Vector3d direction_in(const SphericalTriangle& triangle, double s, double t);

/// Directions drawn uniformly from the solid angle under which a point of the source sees the target.
class SolidAngle : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "solid_angle",
        .summary = "directions from points of the source, uniform in the solid angle of the target",
        .details =
            "A 4-D point gives a point on the source patch (2) and a direction (2), uniform in the solid angle of the "
            "target\npatch as seen from there: a spherical rectangle (Ureña, Fajardo and King), or two triangles "
            "(Arvo). The value is solid angle times cosine over pi: between 0\nand 2, so that the variance is finite "
            "wherever faces touch, and every direction meets the target, however small\nit is. Unbiased with random "
            "points. Occlusion is tested point by point. Faces have to be\nparallelograms and "
            "triangles; samples_per_patch counts points per pair of patches.",
        .reference = "arvo1995",
        .dimension = 4,
        .points = PointsServe::pairs,
        .sees_occluders = true,
        .needs_polygons = true,
        .largest_value = 2,
        .nanoseconds = 150,
        // It has kinks where one triangle meets the other.
        .integrands = {.apart = Integrand::rough, .adjacent = Integrand::rough},
    };

    static constexpr auto largest_unmet = &largest_unmet_factor;

    using SceneEstimator::SceneEstimator;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;
};

}  // namespace ff

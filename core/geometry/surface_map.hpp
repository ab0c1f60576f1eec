#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace ff {

/// A place on a surface and unit vectors there.
struct SurfacePoint {
    Eigen::Vector3d position;
    Eigen::Vector3d normal;   ///< out of the radiating side
    Eigen::Vector3d tangent;  ///< along edge_u, from b to c, or where the azimuth grows
};

/// Coordinates of a place on a surface, in [0, 1].
struct SurfaceCoordinates {
    double s = 0;
    double t = 0;
};

/// The map from the unit square onto a surface that preserves ratios of area, with its inverse;
/// core/geometry/scene.hpp defines s and t. Azimuths begin at the coordinate axis that is farthest from the shape's
/// own, the first of several.
class SurfaceMap {
  public:
    explicit SurfaceMap(const Surface& surface);

    /// The same bits on every CPU.
    [[nodiscard]] SurfacePoint at(double s, double t) const;

    /// @pre `place` lies on the surface, up to rounding
    [[nodiscard]] SurfaceCoordinates coordinates(const Eigen::Vector3d& place) const;

  private:
    Shape shape_;
    Eigen::Vector3d normal_;
    Eigen::Vector3d x_;  ///< azimuth 0 of round shapes, else the tangent; unit length like y and z
    Eigen::Vector3d y_;  ///< azimuth 1/4
    Eigen::Vector3d z_;  ///< along the axis
};

/// The normal of a surface's radiating side at a place on it, up to rounding.
Eigen::Vector3d normal_at(const Surface& surface, const Eigen::Vector3d& place);

/// A unit vector perpendicular to `axis`: the coordinate axis farthest from it, projected.
Eigen::Vector3d perpendicular(const Eigen::Vector3d& axis);

/// The least and the greatest dot product of `direction` with the points of a surface, or with some points.
struct Extent {
    double low = 0;
    double high = 0;
};
Extent extent(const Surface& surface, const Eigen::Vector3d& direction);
Extent extent(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& direction);

/// The axis-aligned box around a surface, around all of a scene, or around each of several surfaces.
Eigen::AlignedBox3d box_around(const Surface& surface);
Eigen::AlignedBox3d box_around(const Scene& scene);
std::vector<Eigen::AlignedBox3d> boxes_around(std::span<const Surface> surfaces);

/// The middle of that box.
Eigen::Vector3d middle(const Surface& surface);

}  // namespace ff

#pragma once

#include "core/geometry/placement.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ff::studies::form_factors {

/// A factor with an interval.
struct PointFactor {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// Form factors from an element of area, such as a sensor, to the faces of a scene: exact up to rounding, since the
/// part of every polygon that is seen past all others is found.
class PointFactors {
  public:
    /// @throws UserError where a surface is curved
    explicit PointFactors(const Scene& scene);

    /// @param given  place, in the scene's unit of length @param direction  normal of any length, > 0 @return by face
    [[nodiscard]] std::vector<PointFactor> from(const Eigen::Vector3d& given, const Eigen::Vector3d& direction) const;

  private:
    Placement placement_;
    Scene scene_;
    std::vector<Eigen::AlignedBox3d> boxes_;       ///< box around each surface of the scene
    double gap_ = 0;                               ///< a place nearer to a plane than this lies in it
    std::vector<std::vector<std::size_t>> level_;  ///< for each surface, the others that lie over it in its plane
};

}  // namespace ff::studies::form_factors

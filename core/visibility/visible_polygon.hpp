#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff {

/// What a differential area sees of a plane convex surface past opaque plane convex ones, exactly: the shadows that
/// they cast from there are cut out of the polygon, piece by piece, and Lambert's formula adds up what is left. No ray
/// is traced, so that an integral over places has only two dimensions, and a continuous integrand.
class VisiblePolygon {
  public:
    /// @pre all surfaces are parallelograms or triangles, and outlive this
    VisiblePolygon(const Surface& target, const std::vector<const Surface*>& blockers);

    /// Form factors from an element of area there.
    struct Factors {
        double whole = 0;    ///< as if nothing stood in between
        double visible = 0;  ///< of what is seen; at most `whole`, but for rounding
    };

    /// @param normal  of the element, unit length
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;
    /// The same where only these blockers, by their index, can stand in between.
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                               std::span<const std::uint32_t> blockers) const;

  private:
    using Polygon = std::vector<Eigen::Vector3d>;

    Polygon target_;  ///< counter-clockwise as seen from the side that receives
    Eigen::Vector3d target_normal_;
    std::vector<Polygon> blockers_;
    std::vector<std::uint32_t> all_;
};

}  // namespace ff

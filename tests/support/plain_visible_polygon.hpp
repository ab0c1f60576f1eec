#pragma once

#include "core/geometry/fwd.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff::test {

/// Does what VisiblePolygon does, one place and one edge at a time, with the arc tangent of the C library: the oracle
/// of its tests.
class PlainVisiblePolygon {
  public:
    /// @pre all surfaces are parallelograms or triangles, and outlive this
    PlainVisiblePolygon(const Surface& target, const std::vector<Blocker>& blockers);

    /// Form factors from an element of area at a place.
    struct Factors {
        double whole = 0;    ///< unoccluded
        double visible = 0;  ///< factor to the visible part; at most `whole`, up to rounding
    };

    /// @param normal  of the element, unit length
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;
    /// The same with these blockers only, given by index.
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                               std::span<const std::uint32_t> blockers) const;

  private:
    std::vector<Eigen::Vector3d> target_;  ///< counter-clockwise as seen from the side that receives
    Eigen::Vector3d target_normal_;
    std::vector<std::vector<Eigen::Vector3d>> blockers_;  ///< the parts in front of the target
    std::vector<std::uint32_t> all_;
};

}  // namespace ff::test

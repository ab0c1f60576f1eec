#pragma once

#include "core/geometry/fwd.hpp"
#include "core/geometry/joined_surfaces.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ff {

/// The surfaces of a scene, halved repeatedly by place. The upper clusters consist of whole walls: level surfaces
/// joined whatever face they belong to. Below each wall are clusters of the surfaces that it is made of.
class ClusterTree {
  public:
    static constexpr std::uint32_t no_wall = std::numeric_limits<std::uint32_t>::max();

    struct Cluster {
        Eigen::AlignedBox3d box;
        /// Corners of a convex set that contains the cluster: the rectangle around it in its plane, or the box.
        std::array<Eigen::Vector3d, 8> corners;
        std::uint8_t corner_count = 0;
        /// The common normal, of unit length; 0 where the cluster does not lie in one plane.
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        double plane = 0;              ///< normal * v of its places
        double grain = 0;              ///< longest edge of the box around its smallest surface
        double size = 0;               ///< diagonal of its own box
        std::uint32_t wall = no_wall;  ///< the wall that all of it belongs to
        bool is_wall = false;          ///< the cluster is all of that wall
        std::uint32_t first = 0;       ///< place of its first surface in `order`
        std::uint32_t count = 0;
        /// The cluster of its upper half; that of the lower half is the next one. 0 where it is a single surface.
        std::uint32_t upper = 0;

        [[nodiscard]] bool is_flat() const { return !normal.isZero(0); }
        [[nodiscard]] bool is_leaf() const { return upper == 0; }
        [[nodiscard]] std::span<const Eigen::Vector3d> hull() const { return {corners.data(), corner_count}; }
    };

    /// @param walls  the surfaces of a scene, joined
    ClusterTree(const std::vector<Surface>& surfaces, const JoinedSurfaces& walls);

    [[nodiscard]] const Cluster& operator[](std::uint32_t cluster) const { return clusters_[cluster]; }
    [[nodiscard]] bool empty() const { return clusters_.empty(); }
    /// All surfaces, those of each cluster together.
    [[nodiscard]] std::uint32_t surface(std::uint32_t place) const { return order_[place]; }
    /// The cluster that consists of a surface alone.
    [[nodiscard]] std::uint32_t leaf_of(std::uint32_t surface) const { return leaf_of_[surface]; }

  private:
    std::vector<Cluster> clusters_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> leaf_of_;

    class Builder;
};

}  // namespace ff

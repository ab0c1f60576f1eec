#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace ff {

/// What can stand in the way in a scene: its surfaces, of which level ones are joined whatever face they belong to, in
/// a hierarchy of boxes. A wall of a hundred facets is one occluder.
class Occluders {
  public:
    explicit Occluders(const Scene& scene);

    /// What is proved of all lines from one surface to another.
    struct Between {
        bool all_hidden = false;                ///< a single occluder crosses all of them
        std::vector<const Surface*> occluders;  ///< those not shown to keep clear of them; they live as long as this
    };

    /// Whether occluders keep clear is asked of planes across the axes and the normals (core/visibility/occlusion.hpp),
    /// then of polygons that shaft between the parts in front of each other (core/geometry/shaft.hpp). Conservative.
    /// @param from, to  indices of surfaces of the scene
    [[nodiscard]] Between between(std::size_t from, std::size_t to) const;

    [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }

  private:
    /// A box around the occluders order_[first .. first + count). The lower half of them is the next node.
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        std::uint32_t upper = 0;  ///< node of the upper half; 0 where it is not divided
    };

    std::vector<Surface> ends_;      ///< the surfaces of the scene
    std::vector<Surface> surfaces_;  ///< joined
    std::vector<std::size_t> of_;    ///< occluder that holds a surface of the scene
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;

    std::uint32_t build(std::uint32_t first, std::uint32_t count, const std::vector<Eigen::AlignedBox3d>& boxes);
};

}  // namespace ff

#pragma once

#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/convex_bodies.hpp"

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace ff {

/// The potential obstacles of a scene: its surfaces in a hierarchy of boxes, coplanar ones joined whatever face they
/// belong to. A wall of a hundred facets is one occluder.
class Occluders {
  public:
    explicit Occluders(const Scene& scene);

    /// What is proved about all lines from one surface to another.
    struct Between {
        bool all_hidden = false;  ///< a single occluder or convex body blocks all of them
        /// The occluders not shown to keep clear of them; they live as long as this. Of a convex body, only the sides
        /// that one of the two surfaces sees.
        std::vector<const Surface*> occluders;
    };

    /// For all lines from one occluder to another, hence for those between any surfaces that they are made of. Whether
    /// occluders keep clear is tested with planes across the axes and the normals (core/visibility/occlusion.hpp), then
    /// for polygons with the shaft between the parts in front of each other (core/geometry/shaft.hpp). Conservative.
    [[nodiscard]] Between between_walls(std::size_t from, std::size_t to) const;

    /// The same for two surfaces of the scene.
    /// @param of_walls  what is proved about the occluders that contain them
    [[nodiscard]] Between between(std::size_t from, std::size_t to, const Between& of_walls) const;
    [[nodiscard]] Between between(std::size_t from, std::size_t to) const {
        return between(from, to, between_walls(of_[from], of_[to]));
    }

    /// The occluder that contains a surface of the scene.
    [[nodiscard]] std::size_t wall_of(std::size_t surface) const { return of_[surface]; }

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
    ConvexBodies bodies_;            ///< those that `surfaces_` bound
    std::vector<std::size_t> of_;    ///< occluder that contains a surface of the scene
    std::vector<double> grain_;      ///< area share of the smallest surface of each occluder
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;

    Occluders(const Scene& scene, JoinedSurfaces joined);

    [[nodiscard]] std::size_t index_of(const Surface* occluder) const {
        return static_cast<std::size_t>(occluder - surfaces_.data());
    }
    /// For two surfaces alone, without the test of bodies.
    [[nodiscard]] Between between_parts(std::size_t from, std::size_t to, const Between& of_walls) const;
    /// Tests bodies with several sides between two surfaces.
    [[nodiscard]] bool one_body_hides_all(const Between& between, const Surface& from, const Surface& to) const;
    void drop_far_sides(Between& between, const Surface& from, const Surface& to) const;

    std::uint32_t build(std::uint32_t first, std::uint32_t count, const std::vector<Eigen::AlignedBox3d>& boxes);
};

/// Cache of what is proved between walls, computed on first use and valid for all surfaces of both. For one
/// thread.
class WallViews {
  public:
    explicit WallViews(const Occluders& occluders) : occluders_(occluders) {}

    Occluders::Between between(std::size_t from, std::size_t to);

  private:
    const Occluders& occluders_;
    std::map<std::pair<std::size_t, std::size_t>, Occluders::Between> of_walls_;
};

}  // namespace ff

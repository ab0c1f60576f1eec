#pragma once

#include "core/geometry/fwd.hpp"
#include "core/geometry/joined_surfaces.hpp"
#include "core/geometry/shaft.hpp"
#include "core/visibility/bodies.hpp"
#include "core/visibility/cluster_tree.hpp"
#include "core/visibility/curtains.hpp"
#include "core/visibility/facing.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace ff {

/// The potential obstacles of a scene: its surfaces in a hierarchy, level ones joined whatever face they belong to. A
/// wall of a hundred facets is one occluder. What is proved about all lines between two clusters of surfaces serves all
/// pairs of them. Surfaces that overlap in one plane but for rounding (core/visibility/level_overlaps.hpp) neither hide
/// nor see each other.
class Occluders {
  public:
    explicit Occluders(const Scene& scene);

    /// The facts that are proved about all lines from one surface to another.
    struct Between {
        bool all_hidden = false;  ///< a single occluder or convex body blocks all of them
        /// The occluders not shown to keep clear of them, in a fixed order; they live as long as this. Of a convex
        /// body, only the sides that one of the two surfaces sees.
        std::vector<Blocker> occluders;
    };

    /// Two clusters of surfaces, and the clusters that contain what may stand between them.
    struct Visit {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        std::vector<std::uint32_t> between;
        double pairs = 0;  ///< number of pairs of surfaces
    };

    /// Visits that together cover each unordered pair of surfaces once, including each surface with itself, except
    /// pairs that are wholly hidden from each other.
    /// @param most_pairs  most pairs of surfaces in a visit
    [[nodiscard]] std::vector<Visit> visits(double most_pairs) const;

    /// Receives two surfaces by their indices, the smaller index first.
    using See = std::function<void(std::uint32_t from, std::uint32_t to, const Between& between)>;

    /// Calls `see` for all pairs of surfaces of a visit that belong to faces and face each other, unless everything
    /// between them is hidden.
    void see(const Visit& visit, const See& see) const;

    [[nodiscard]] Between between(std::size_t from, std::size_t to) const;

    /// Whether parts of each of two surfaces may lie in front of the other.
    [[nodiscard]] bool face_each_other(std::size_t from, std::size_t to) const;

    [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }  ///< the surfaces of the scene
    [[nodiscard]] const std::vector<Surface>& walls() const { return walls_; }

  private:
    using WallPair = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<Surface> surfaces_;  ///< the surfaces of the scene
    std::vector<Surface> walls_;     ///< surfaces, joined to walls
    bool are_none_;                  ///< nothing stands between any two surfaces
    SharedEdges edges_;              ///< edges of walls; everything below is about walls, too
    ConvexBodies bodies_;
    ClosedMeshes meshes_;
    ClusterTree tree_;
    std::vector<std::optional<Plate>> plates_;  ///< one for each wall; empty for round ones
    std::vector<WallPair> level_;               ///< pairs of walls that overlap in one plane, sorted
    std::vector<bool> is_level_with_any_;       ///< for each wall, whether it is level with another
    std::vector<std::uint32_t> place_of_wall_;  ///< for each wall, the place of one of its surfaces in the tree

    class Walk;

    Occluders(const Scene& scene, const JoinedSurfaces& joined);

    [[nodiscard]] std::uint32_t wall_of(std::size_t surface) const {
        return tree_[tree_.leaf_of(static_cast<std::uint32_t>(surface))].wall;
    }
    [[nodiscard]] bool are_level(std::uint32_t a, std::uint32_t b) const;  ///< walls are given by index

    /// Candidates for what stands between any two surfaces.
    [[nodiscard]] std::vector<std::uint32_t> candidates() const;
    [[nodiscard]] std::size_t index_of(const Surface* wall) const {
        return static_cast<std::size_t>(wall - walls_.data());
    }
    /// A number for the body or mesh that a wall is a side of; SharedEdges::none where it is a side of none.
    [[nodiscard]] std::uint32_t body_or_mesh(std::size_t wall) const;
    [[nodiscard]] FacedEnd end_to_face(std::size_t wall, std::size_t from, std::size_t to) const;
    void drop_far_sides(Between& between, std::size_t from, std::size_t to) const;
};

}  // namespace ff

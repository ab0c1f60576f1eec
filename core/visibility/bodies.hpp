#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/fwd.hpp"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ff {

/// Which polygons of a scene meet along a whole edge of both. Normals agree across it.
class SharedEdges {
  public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    explicit SharedEdges(const std::vector<Surface>& surfaces);

    /// The outline of a surface; empty for round ones. Its k-th edge begins in the k-th corner.
    [[nodiscard]] const ConvexPolygon& outline(std::size_t surface) const { return outlines_[surface]; }
    [[nodiscard]] std::size_t size() const { return outlines_.size(); }
    /// Possible error of corners.
    [[nodiscard]] double corner_room() const { return corner_room_; }
    /// The surface beyond an edge; `none` where there is none or more than one.
    [[nodiscard]] std::uint32_t beyond(std::size_t surface, std::size_t edge) const {
        return beyond_[first_[surface] + edge];
    }

    /// Surfaces in groups that are connected by edges.
    /// @param joins  (surface, the one beyond an edge) -> whether they belong together
    template <class Joins>
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups(const Joins& joins) const {
        std::vector<std::uint32_t> group(size(), none);
        std::vector<std::vector<std::uint32_t>> groups;
        for (std::uint32_t first = 0; first < size(); ++first) {
            if (group[first] != none) continue;
            std::vector<std::uint32_t>& members = groups.emplace_back(1, first);
            group[first] = first;
            for (std::size_t k = 0; k < members.size(); ++k) {
                for (std::size_t edge = 0; edge < outlines_[members[k]].size(); ++edge) {
                    const std::uint32_t next = beyond(members[k], edge);
                    if (next == none || group[next] != none || !joins(members[k], next)) continue;
                    group[next] = first;
                    members.push_back(next);
                }
            }
        }
        return groups;
    }

  private:
    std::vector<ConvexPolygon> outlines_;
    std::vector<std::size_t> first_;  ///< place of each surface's edges
    std::vector<std::uint32_t> beyond_;
    double corner_room_ = 0;
};

/// Convex bodies bounded by polygons of a scene that radiate outwards, such as boxes and prisms. One side may be
/// missing, like the bottom of a building on the ground. A straight line enters a body through a side that it meets
/// from the front, so that from outside the other sides hide nothing more.
class ConvexBodies {
  public:
    ConvexBodies(const std::vector<Surface>& surfaces, const SharedEdges& edges);

    /// The body that a surface, given by its index, is a side of.
    [[nodiscard]] std::optional<std::uint32_t> of(std::size_t surface) const {
        return body_of_[surface] == SharedEdges::none ? std::nullopt : std::optional(body_of_[surface]);
    }

    /// Whether no side is missing.
    [[nodiscard]] bool is_closed(std::uint32_t body) const { return !bodies_[body].missing; }

    /// Whether each line from a polygon meets the front of a side of a body before it meets any side from behind.
    /// Conservative: nothing is concluded for a polygon in the plane of a side.
    [[nodiscard]] bool is_outside(std::uint32_t body, std::span<const Eigen::Vector3d> polygon) const;

  private:
    /// Places behind it have normal * v < offset.
    struct Plane {
        Eigen::Vector3d normal;  ///< unit length, out of the body
        double offset = 0;
    };
    struct Body {
        std::vector<Plane> sides;
        std::optional<Plane> missing;  ///< plane of the missing side
        double size = 0;               ///< longest edge of the box around it, in units of length
    };
    std::vector<Body> bodies_;
    std::vector<std::uint32_t> body_of_;  ///< index of the body that each surface is a side of, or SharedEdges::none
    double room_ = 0;                     ///< allowance for the rounding of corners

    [[nodiscard]] bool is_behind(std::span<const Eigen::Vector3d> polygon, const Plane& plane) const;

    class Finder;
};

/// Meshes of polygons that meet along whole edges everywhere and cut nowhere through themselves: surfaces of bodies, or
/// walls of rooms. A straight line from their free side meets a polygon from the front before it meets any from behind.
class ClosedMeshes {
  public:
    explicit ClosedMeshes(const SharedEdges& edges);

    [[nodiscard]] std::size_t size() const { return meshes_.size(); }
    /// The mesh that a surface, given by its index, is a side of.
    [[nodiscard]] std::optional<std::uint32_t> of(std::size_t surface) const {
        return mesh_of_[surface] == SharedEdges::none ? std::nullopt : std::optional(mesh_of_[surface]);
    }

    /// Whether each line from a polygon meets the front of a side of a mesh before it meets any side from behind.
    /// Conservative.
    /// @param surface  that the polygon is a part of, by its index
    [[nodiscard]] bool is_on_free_side(std::uint32_t mesh, std::size_t surface,
                                       std::span<const Eigen::Vector3d> polygon) const;

  private:
    struct Mesh {
        Eigen::AlignedBox3d box;
        bool is_body = false;  ///< the free side is the outside
    };
    std::vector<Mesh> meshes_;
    std::vector<std::uint32_t> mesh_of_;  ///< mesh of each surface, or SharedEdges::none
    double room_ = 0;                     ///< allowance for the rounding of corners
};

}  // namespace ff

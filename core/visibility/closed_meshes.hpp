#pragma once

#include "core/visibility/shared_edges.hpp"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff {

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
    std::vector<std::uint32_t> mesh_of_;  ///< by surface, or SharedEdges::none
    double room_ = 0;                     ///< allowance for the rounding of corners
};

}  // namespace ff

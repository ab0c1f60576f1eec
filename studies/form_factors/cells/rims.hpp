#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// Bounds of a part of a surface. Places are relative to an origin near it.
struct PartExtent {
    std::vector<Eigen::Vector3d> hull;  ///< corners of a convex set that holds the part
    Eigen::Vector3d centre;
    double radius = 0;  ///< the ball of this radius around `centre` holds the part
    double size = 0;    ///< largest distance of two places
    double turn = 0;    ///< largest difference of two unit normals
};

/// Edges of a target and of the obstacles before it. The rims of the visible and of the hidden part consist of these,
/// and how fast they move bounds how fast form factors change. Places are relative to an origin near the source.
class Rims {
  public:
    struct Edge {
        Eigen::Vector3d a;
        Eigen::Vector3d b;
    };

    /// @param target  the part of it that is above the horizon of a flat source
    Rims(const Surface& source, const ConvexPolygon& target);

    /// @param edges  at which its shadow may end
    void add_blocker(const std::vector<Edge>& edges);

    /// Upper bound of the change of the factor to the visible, or hidden, part of the target per length that a place in
    /// the part moves; infinite beside an edge. An edge shared by two blockers is counted once.
    /// @param blockers  in the order in which they were added, from 0
    [[nodiscard]] double slope(const PartExtent& part, std::span<const std::uint32_t> blockers) const;

  private:
    const Surface& source_;
    ConvexPolygon target_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> target_edges_;
    std::vector<std::vector<std::uint32_t>> blocker_edges_;

    std::vector<std::uint32_t> indices_of(const std::vector<Edge>& edges);
    [[nodiscard]] double slope_of(const PartExtent& part, const Edge& edge, double most_angle) const;
    [[nodiscard]] double widest_angle(const PartExtent& part) const;
};

/// All edges of a polygon.
std::vector<Rims::Edge> edges_of(const ConvexPolygon& polygon);

}  // namespace ff::studies::form_factors

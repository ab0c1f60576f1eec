#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "studies/form_factors/division/source_part.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// Edges of a target and of the obstacles before it. The rims of the visible and of the hidden part consist of these,
/// and how fast they move bounds how fast form factors change. Places are relative to an origin near the source.
class Rims {
  public:
    /// @param target  the part of it that is above the horizon of a flat source
    Rims(const Surface& source, const ConvexPolygon& target);

    void add_blocker(const ConvexPolygon& polygon);

    /// Upper bound of the change of the factor to the visible, or hidden, part of the target per length that a place in
    /// the part moves; infinite beside an edge. An edge shared by two blockers is counted once.
    /// @param blockers  in the order in which they were added, from 0
    [[nodiscard]] double slope(const PartExtent& part, std::span<const std::uint32_t> blockers) const;

  private:
    struct Edge {
        Eigen::Vector3d a;
        Eigen::Vector3d b;
    };
    const Surface& source_;
    ConvexPolygon target_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> target_edges_;
    std::vector<std::vector<std::uint32_t>> blocker_edges_;

    std::vector<std::uint32_t> edges_of(const ConvexPolygon& polygon);
    [[nodiscard]] double slope_of(const PartExtent& part, const Edge& edge, double most_angle) const;
    [[nodiscard]] double widest_angle(const PartExtent& part) const;
};

}  // namespace ff::studies::form_factors

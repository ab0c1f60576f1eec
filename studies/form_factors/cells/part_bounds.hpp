#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/facing.hpp"
#include "studies/form_factors/cells/blocked_pair.hpp"

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

/// All edges of a polygon.
std::vector<RimEdge> edges_of(const ConvexPolygon& polygon);

/// Edges of a target and of the obstacles before it. The rims of the visible and of the hidden part consist of these,
/// and how fast they move bounds how fast form factors change. Places are relative to an origin near the source.
class Rims {
  public:
    /// @param target  the part of it that is above the horizon of a flat source
    Rims(const Surface& source, const ConvexPolygon& target);

    /// @param edges  at which its shadow may end
    void add_blocker(const std::vector<RimEdge>& edges);

    /// Upper bound of the change of the factor to the visible, or hidden, part of the target per length that a place in
    /// the part moves; infinite beside an edge. An edge shared by two blockers is counted once.
    /// @param blockers  in the order in which they were added, from 0
    [[nodiscard]] double slope(const PartExtent& part, std::span<const std::uint32_t> blockers) const;

  private:
    const Surface& source_;
    ConvexPolygon target_;
    std::vector<RimEdge> edges_;
    std::vector<std::uint32_t> target_edges_;
    std::vector<std::vector<std::uint32_t>> blocker_edges_;

    std::vector<std::uint32_t> indices_of(const std::vector<RimEdge>& edges);
    [[nodiscard]] double slope_of(const PartExtent& part, const RimEdge& edge, double most_angle) const;
    [[nodiscard]] double widest_angle(const PartExtent& part) const;
};

/// Bounds by geometry of the factor from places in a part of a source to what they see of a polygon, or to what is
/// hidden of it from them. Whatever the size of a blocker or a gap, its possible shadow is found in this way rather
/// than met by chance.
class PartBounds {
  public:
    /// Two polygons. @param rim  of the pair @param blockers  number of all blockers that may stand between
    PartBounds(const Surface& source, const BlockedPair& pair, const std::vector<RimEdge>& rim, std::size_t blockers);
    /// A round source. @param origin  near it; places are relative to it
    PartBounds(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
               const Eigen::Vector3d& origin);

    /// All are 0 where nothing is hidden and the part is small beside its distance from the target, so that no peak
    /// of the factor is overlooked.
    struct Bounds {
        std::vector<std::uint32_t> blockers;  ///< those that may hide something, by index
        double visible = 0;                   ///< upper bound of the factor to the visible part
        double hidden = 0;                    ///< upper bound of the factor to the hidden part
        double change = 0;  ///< upper bound of what either changes by between two places; infinite beside an edge
    };

    /// @param blockers  that may hide something from the part
    [[nodiscard]] Bounds of(const PartExtent& part, std::span<const std::uint32_t> blockers) const;
    /// All blockers that may hide something from some part.
    [[nodiscard]] std::vector<std::uint32_t> blockers() const;

  private:
    /// A polygon that something is known of.
    struct Polygon {
        ConvexPolygon corners;
        Eigen::Vector3d normal;  ///< twice as long as the area is large
        double area = 0;

        explicit Polygon(ConvexPolygon polygon);
    };

    const Surface& source_;
    bool is_plane_;
    Polygon target_;
    std::vector<Polygon> blockers_;  ///< empty ones hide nothing
    Rims rims_;

    [[nodiscard]] ConvexPolygon above_horizon(const Surface& surface, const Eigen::Vector3d& origin) const;
    [[nodiscard]] double most_to(const Polygon& polygon, const PartExtent& part) const;
};

}  // namespace ff::studies::form_factors

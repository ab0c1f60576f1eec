#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/blocker.hpp"
#include "studies/form_factors/cells/blocked_pair.hpp"
#include "studies/form_factors/cells/rims.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff::studies::form_factors {

/// What geometry shows of the factor from places in a part of a source to what they see of a polygon, or to what is
/// hidden of it from them. Whatever the size of a blocker or a gap, its possible shadow is found in this way, not met
/// by chance.
class PartBounds {
  public:
    /// Two polygons. @param rim  of the pair @param blockers  number of all that may stand between
    PartBounds(const Surface& source, const BlockedPair& pair, const std::vector<RimEdge>& rim, std::size_t blockers);
    /// A round source. @param origin  near it; places are relative to it
    PartBounds(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
               const Eigen::Vector3d& origin);

    /// All are 0 where nothing is hidden and the part is small beside its distance from the target, so that no peak
    /// of the factor is overlooked.
    struct Bounds {
        std::vector<std::uint32_t> blockers;  ///< those that may hide something, by index
        double visible = 0;                   ///< upper bound of the factor to what is seen
        double hidden = 0;                    ///< and to what is hidden
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

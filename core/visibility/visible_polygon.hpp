#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/shadow_edges.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace ff {

/// The exact part of a plane convex surface that a differential area sees past opaque plane convex ones: what their
/// shadows leave of the polygon is outlined, and Lambert's formula adds up the outline. No ray is traced, so that an
/// integral over places has only two dimensions, and a continuous integrand.
class VisiblePolygon {
  public:
    /// @param place_at  the end of the pair that places lie on; the target is the other one
    /// @pre all surfaces are parallelograms or triangles
    VisiblePolygon(const Surface& target, const std::vector<Blocker>& blockers, FacedEnd place_at = FacedEnd::from);

    /// Form factors from an element of area at a place.
    struct Factors {
        double whole = 0;    ///< unoccluded
        double visible = 0;  ///< factor to the visible part; at most `whole`, up to rounding
    };

    /// @param normal  of the element, unit length
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const {
        return from(place, normal, all_);
    }
    /// The same with these blockers only, given by index.
    [[nodiscard]] Factors from(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                               std::span<const std::uint32_t> blockers) const;
    /// Finds the factors from elements of one plane at once, which takes less time. @param result  as many as places
    void find(std::span<const Eigen::Vector3d> places, const Eigen::Vector3d& normal, std::span<Factors> result) const {
        find(places, normal, all_, result);
    }
    /// The same with these blockers only, given by index.
    void find(std::span<const Eigen::Vector3d> places, const Eigen::Vector3d& normal,
              std::span<const std::uint32_t> blockers, std::span<Factors> result) const;

  private:
    ConvexPolygon target_;  ///< counter-clockwise as seen from the side that receives
    Eigen::Vector3d target_normal_;
    // What follows is found from what stands before it.
    double rounding_ = 0;                  ///< possible rounding error of coordinates
    std::vector<ConvexPolygon> blockers_;  ///< the parts in front of the target
    /// Whether a blocker hides something from places on either side of its plane, before it only, or behind.
    enum class Hides : std::uint8_t { always, from_before, from_behind };
    std::vector<Hides> hides_;
    std::vector<std::uint32_t> all_;
    ShadowEdges edges_;

    std::vector<ConvexPolygon> parts_before_target(const std::vector<Blocker>& blockers);
};

}  // namespace ff

#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/shared_edges.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ff {

/// Convex bodies bounded by polygons of a scene that radiate outwards, such as boxes and prisms. One side may be
/// missing, like the bottom of a building on the ground. A straight line enters a body through a side that it meets
/// from the front, so that from outside the other sides hide nothing more.
class ConvexBodies {
  public:
    ConvexBodies(const std::vector<Surface>& surfaces, const SharedEdges& edges);

    /// The body that a surface, given by its index, is a side of.
    [[nodiscard]] std::optional<std::uint32_t> of(std::size_t surface) const;

    /// Whether no side is missing.
    [[nodiscard]] bool is_closed(std::uint32_t body) const { return !bodies_[body].misses_one; }

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
        std::vector<Plane> planes;  ///< of its sides; the last one of a side that is missing, if there is one
        bool misses_one = false;
        double size = 0;  ///< longest edge of the box around it, in units of length

        [[nodiscard]] std::span<const Plane> sides() const {
            return std::span(planes).first(planes.size() - (misses_one ? 1 : 0));
        }
    };
    std::vector<Body> bodies_;
    std::vector<std::uint32_t> body_of_;  ///< index of the body that each surface is a side of, or `no_body`
    double room_ = 0;                     ///< allowance for the rounding of corners

    class Finder;
};

}  // namespace ff

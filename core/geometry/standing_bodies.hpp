#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/fwd.hpp"

#include <optional>
#include <vector>

namespace ff {

/// Bodies that stand on surfaces which are not cut out beneath them, as is common in models.
struct StandingBodies {
    /// The rest of each surface beside bodies that stand on it or surfaces it stands on; empty where there are none. No
    /// polygon where nothing is left.
    std::vector<std::optional<std::vector<ConvexPolygon>>> left;

    [[nodiscard]] bool any() const { return !left.empty(); }
};

/// Finds the parts that two surfaces cover of each other: the bottom of a body on a surface that faces it in the same
/// plane, which differs from the two sides of a thin wall in that the body's sides rise at the bottom's edges in front
/// of the surface; and the inside of the rim of a body without a bottom, where everything but the rims is closed and
/// each rim lies on surfaces that face the body, in one plane or in several, as in a corner of a room.
/// For polygons whose corners are in common; bodies that it does not understand, such as round ones, stay as they are.
/// @param gap  planes and lines nearer than this are one
StandingBodies standing_bodies(const Scene& scene, double gap);

}  // namespace ff

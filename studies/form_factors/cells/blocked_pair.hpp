#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Two polygons and those that may stand between them, each cut to its part in front of both. Places are relative to
/// an origin near the source.
struct BlockedPair {
    Eigen::Vector3d origin;
    Eigen::Vector3d source_normal;
    ConvexPolygon source;  ///< empty where nothing of it is in front of the target, or the other way round
    ConvexPolygon target;
    std::vector<ConvexPolygon> blockers;  ///< without those that are cut off entirely
    std::vector<std::uint32_t> indices;   ///< indices of these among those that may stand between
    double size = 0;                      ///< largest distance of a corner from the origin

    BlockedPair(const Surface& from, const Surface& to, const std::vector<Blocker>& between);
};

/// An edge of a blocker at which what the source sees of the target may end.
struct RimEdge {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    std::size_t blocker = 0;  ///< index into BlockedPair::blockers
};

/// The edges of a pair. Edges that no line between the two ends crosses are left out, and so are those between two
/// blockers whose shadows lie on either side of them for all places of the source.
std::vector<RimEdge> rim_of(const BlockedPair& pair);

/// The source cut along lines at which what it sees of the target changes its shape: planes through a blocker's edge
/// and a corner of the target, a corner and an edge of the target, a corner of one blocker and an edge of another, and
/// planes of blockers that the source lies on both sides of. Within a part the factor to what is seen is analytic,
/// except where three edges meet in one line of sight: there its second derivative jumps. Lines count only where the
/// event is within the edges as seen from the source.
/// @param rim  of the pair
/// @return convex parts, or none where there are more than `most_parts`
std::vector<ConvexPolygon> smooth_parts(const BlockedPair& pair, const std::vector<RimEdge>& rim,
                                        std::size_t most_parts);

}  // namespace ff::studies::form_factors

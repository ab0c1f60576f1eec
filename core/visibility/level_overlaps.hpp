#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>
#include <vector>

namespace ff {

/// Planes nearer than this may differ only by rounding: that of the coordinates as they were read, that of computing
/// with them, and the tolerance of proofs about occlusion (core/visibility/facing.hpp). So a surface in front of
/// another either hides it or is level with it.
double level_gap(const Scene& scene);

/// How far apart surfaces on a slanting plane may lie that were drawn in one plane, if coordinates were rounded to the
/// scene's coordinate_step; 0 where there is no such step.
double doubtful_gap(const Scene& scene);

/// Whether a surface lies in a plane along two of the axes: rounding moves all of such a plane to the same place.
bool is_along_axes(const Surface& surface);

/// Two surfaces that overlap in one plane, or nearly.
struct LevelOverlap {
    std::uint32_t first = 0;  ///< index of a surface
    std::uint32_t second = 0;
    bool same_side = false;  ///< they radiate to the same side; else they are back to back, as the sides of a thin wall
    double area = 0;         ///< covered by both; approximate for discs
    bool level = true;       ///< they are within level_gap: coordinates do not tell which of them hides the other
    bool in_doubt = false;   ///< nor do they here if they were rounded to the scene's coordinate_step
    /// They are level, and no more lies twice than corners may leave that were rounded to the coordinate_step, where
    /// polygons abut whose edges are not along axes.
    bool by_rounding = false;
};

/// All overlaps of a scene that cover at least a millionth of the smaller surface, and more than rounding can cover
/// along its rim; for discs, those that are found by a lattice of 1024 places. Those that are not level lie apart by a
/// millionth of the smaller surface's size at most or, on planes that slant, by what rounding to the scene's
/// coordinate_step may do. Takes n log n steps for n surfaces with few neighbours each.
std::vector<LevelOverlap> level_overlaps(const Scene& scene);

/// The area of the first that the second covers, seen along the first's normal; for discs on a lattice of places.
/// @pre both are flat
double common_area(const Surface& a, const Surface& b);

}  // namespace ff

#pragma once

#include "core/geometry/scene.hpp"

#include <cstdint>
#include <vector>

namespace ff {

/// By this share of a scene's largest coordinate, planes that are the same may lie apart for rounding alone.
inline constexpr double level_rounding = 0x1p-46;

/// Two coplanar surfaces that overlap. Coordinates do not tell which of them hides the other.
struct LevelOverlap {
    std::uint32_t first = 0;  ///< index of a surface
    std::uint32_t second = 0;
    bool same_side = false;  ///< they radiate to the same side; else they are back to back, as the sides of a thin wall
    double area = 0;         ///< covered by both; approximate for discs
};

/// All overlaps of a scene that cover at least a millionth of the smaller surface; for discs, those that show on a
/// lattice of 1024 places. Planes count as equal within 2^-46 of the scene's largest coordinate. Takes n log n steps
/// for n surfaces with few neighbours each.
std::vector<LevelOverlap> level_overlaps(const Scene& scene);

/// Whether the corners of one flat surface, or the rim of a disc, lie within `gap` of the plane of the other.
bool lie_in_one_plane(const Surface& a, const Surface& b, double gap);

/// The area of the first that the second covers, seen along the first's normal; for discs on a lattice of places.
/// @pre both are flat
double common_area(const Surface& a, const Surface& b);

}  // namespace ff

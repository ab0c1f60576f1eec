#pragma once

#include "core/geometry/scene.hpp"
#include "core/patches/allocation.hpp"
#include "core/points/points.hpp"
#include "core/tracing/tracer.hpp"

#include <cstdint>
#include <vector>

namespace ff {

/// Integer outcome of one trial of ray shooting.
struct RayTally {
    std::vector<std::uint64_t> hits;  ///< [from_face * faces + to_face]
    std::vector<std::uint64_t> rays;  ///< [from_face]
    std::vector<std::uint64_t> lost;  ///< [from_face]
    /// [from_face * faces + to_face], the hits of each surface times the area of a part of its grid, summed in the
    /// order of surfaces: faces of several surfaces are averages by area.
    std::vector<double> weighted;
};

/// Sums over trials of patch-to-face hits and of their squares, [patch * faces + face]; exact integers.
struct PatchSums {
    std::vector<std::uint64_t> hits;
    std::vector<std::uint64_t> hits_squared;
};

/// One trial of ray shooting (the paper's SR): `samples_per_patch` cosine-distributed rays from every patch.
/// `tally` is replaced by this trial's outcome, `sums` (empty, or from earlier trials of the same size) added to; null
/// where patches are too many to be told apart.
/// @pre points.equal_weights()   `key` and `trial` select the streams
void ray_shooting(const Scene& scene, Subdivision subdivision, const Tracer& tracer, const PointSource& points,
                  std::uint64_t samples_per_patch, Allocation allocation, StreamKey key, std::uint32_t trial,
                  RayTally& tally, PatchSums* sums);

}  // namespace ff

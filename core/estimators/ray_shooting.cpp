#include "core/estimators/ray_shooting.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <functional>

namespace ff {
namespace {

/// Adds the hits of one patch to the sums over trials.
void collect(const FaceHits& patch_hits, std::size_t patch, PatchSums& sums) {
    const std::size_t faces = patch_hits.size() - 1;
    for (std::size_t to = 0; to < faces; ++to) {
        const std::uint64_t hits = patch_hits[to];
        sums.hits[patch * faces + to] += hits;
        sums.hits_squared[patch * faces + to] += hits * hits;
    }
}

/// Adds the hits of one surface to those of its face.
void collect(const FaceHits& surface_hits, const Surface& surface, RayTally& tally) {
    const std::size_t faces = surface_hits.size() - 1;
    const auto from = static_cast<std::size_t>(surface.face);
    const double own = area(surface.shape) / surface.grid.parts();
    for (std::size_t to = 0; to < faces; ++to) {
        tally.hits[from * faces + to] += surface_hits[to];
        tally.weighted[from * faces + to] += own * static_cast<double>(surface_hits[to]);
    }
    tally.lost[from] += surface_hits[faces];
}

}  // namespace

void ray_shooting(const Scene& scene, Subdivision subdivision, const Tracer& tracer, const PointSource& points,
                  std::uint64_t samples_per_patch, Allocation allocation, StreamKey key, std::uint32_t trial,
                  RayTally& tally, PatchSums* sums) {
    FF_EXPECT(points.equal_weights());
    const std::size_t faces = scene.faces.size();
    const PatchOrder order(scene, subdivision);
    const PatchSequences sequences(scene, subdivision, allocation, samples_per_patch);
    const std::size_t patches = order.size();
    tally.hits.assign(faces * faces, 0);
    tally.rays.assign(faces, 0);
    tally.lost.assign(faces, 0);
    tally.weighted.assign(faces * faces, 0);
    if (sums != nullptr) {
        FF_EXPECT(sums->hits.size() == sums->hits_squared.size());
        FF_EXPECT(sums->hits.empty() || sums->hits.size() == patches * faces);
        sums->hits.resize(patches * faces);
        sums->hits_squared.resize(patches * faces);
    }

    PointBlock block;
    FaceHits patch_hits(faces + 1);
    FaceHits surface_hits(faces + 1);
    for (std::uint32_t surface = 0; surface < scene.surfaces.size(); ++surface) {
        if (!is_of_face(scene.surfaces[surface])) continue;
        const auto from_face = static_cast<std::size_t>(scene.surfaces[surface].face);
        const Grid grid = subdivision.of(scene.surfaces[surface]);
        std::fill(surface_hits.begin(), surface_hits.end(), 0);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            const auto [source, first] = sequences.of(surface, p);
            const Stream stream{.key = key, .trial = trial, .source = source};
            std::fill(patch_hits.begin(), patch_hits.end(), 0);
            for (std::uint64_t done = 0; done < samples_per_patch; done += block.size) {
                block.size =
                    static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, samples_per_patch - done));
                points.fill(stream, first + done, block);
                tracer.shoot(surface, grid, p, block, patch_hits);
            }
            std::transform(patch_hits.begin(), patch_hits.end(), surface_hits.begin(), surface_hits.begin(),
                           std::plus<>());
            if (sums != nullptr) collect(patch_hits, order.first(surface) + p, *sums);
        }
        collect(surface_hits, scene.surfaces[surface], tally);
        tally.rays[from_face] += grid.parts() * samples_per_patch;
    }
}

}  // namespace ff

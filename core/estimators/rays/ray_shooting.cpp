#include "core/estimators/rays/ray_shooting.hpp"

#include "core/patches/face_averages.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace ff {
namespace {

constexpr double analytic_nanoseconds = 1.0;
constexpr double embree_nanoseconds = 60.0;

/// Single precision traces boxes in this range without loss.
constexpr double least_edge = 1e-9;
constexpr double largest_edge = 1e9;
constexpr double largest_edge_ratio = 1e4;

/// Why the rays of a scene cannot be traced in single precision, and what to do; empty where they can.
std::string why_not_traceable(const Scene& scene) {
    if (!scene.empty_box) return {};  // tracers move and scale it
    const double least = scene.empty_box->minCoeff();
    const double largest = scene.empty_box->maxCoeff();
    if (least >= least_edge && largest <= largest_edge && largest <= least * largest_edge_ratio) return {};
    return fmt::format(
        "scene '{}' cannot be traced (rays have single precision: edges from {:g} to {:g}, in a ratio of at most "
        "{:g}). Use another unit of length, or estimator = \"closed_form\".",
        scene.name, least_edge, largest_edge, largest_edge_ratio);
}

/// Whether sums of every patch are kept: of more numbers than this a unit of work would be too large to save.
bool keeps_patches(const Scene& scene, Subdivision subdivision) {
    constexpr std::uint64_t most = 1u << 22;
    return subdivision.patches(scene) * scene.faces.size() <= most;
}

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
            for_each_block(points, stream, first, samples_per_patch, block,
                           [&](PointIndex) { tracer.shoot(surface, grid, p, block, patch_hits); });
            std::transform(patch_hits.begin(), patch_hits.end(), surface_hits.begin(), surface_hits.begin(),
                           std::plus<>());
            if (sums != nullptr) collect(patch_hits, order.first(surface) + p, *sums);
        }
        collect(surface_hits, scene.surfaces[surface], tally);
        tally.rays[from_face] += grid.parts() * samples_per_patch;
    }
}

std::string RayShooting::refusal(const EstimatorOptions& options, const Scene& scene) {
    if (options.tracer == TracerChoice::box && !scene.empty_box) {
        return fmt::format(
            "the box tracer cannot be used in scene '{}' (it is not an empty box). Use tracer = \"embree\".",
            scene.name);
    }
    return why_not_traceable(scene);
}

double RayShooting::nanoseconds(const EstimatorOptions& options, const Scene& scene) {
    const bool one_by_one =
        options.tracer == TracerChoice::embree || options.tracer == TracerChoice::leaky || !mirrors(scene).empty();
    return scene.empty_box && !one_by_one ? analytic_nanoseconds : embree_nanoseconds;
}

void RayShooting::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const {
    ray_shooting(scene(), task.subdivision, *tracer_, *task.points, task.samples, task.options.allocation, task.key,
                 task.trial, outcome.rays, keeps_patches(scene(), task.subdivision) ? &totals.hits : nullptr);
    outcome.estimates = face_averages(scene(), outcome.rays.weighted, task.subdivision.per_part() * task.samples);
}

}  // namespace ff

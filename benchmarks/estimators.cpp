// Trials of the estimators that integrate instead of tracing, on the cube of the paper.

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/estimators/points/point_to_polygon.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>

namespace {

using namespace ff;

/// The paper's PDM on 1014 patches: all pairs of patches, five Gauss-Legendre nodes a side on each.
void pdm(benchmark::State& state) {
    const Scene scene = make_box(6, 6, 6);
    const auto points = samplers::find("gauss_legendre")
                            .make({.source_nodes = 5, .target_nodes = static_cast<std::uint32_t>(state.range(0))});
    for (auto _ : state) {
        benchmark::DoNotOptimize(area_kernel(scene, {13}, *points, PointMap::uniform, {}, 0));
    }
}
// Equal nodes allow half of the pairs to follow from the others; unequal ones do not.
BENCHMARK(pdm)->Arg(5)->Arg(6)->Unit(benchmark::kMillisecond);

/// Exact factors from points of a face to the five others, points included.
void point_to_polygon_trial(benchmark::State& state) {
    const Scene scene = make_box(6, 6, 6);
    const auto samples = static_cast<std::uint64_t>(state.range(0));
    const auto points = samplers::find("sobol").make({.points = samples, .dimension = 2});
    for (auto _ : state) {
        benchmark::DoNotOptimize(point_to_polygon(scene, {1}, *points, samples, Allocation::patch, {}, 0));
    }
    state.counters["per_point"] =
        benchmark::Counter(6.0 * static_cast<double>(samples),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(point_to_polygon_trial)->Name("point_to_polygon")->Arg(64)->Arg(4096);

}  // namespace

// Exact factors from points of a face to the five others of a cube, points included.

#include "core/estimators/points/point_to_polygon.hpp"

#include "core/geometry/box.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>

namespace {

using namespace ff;

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

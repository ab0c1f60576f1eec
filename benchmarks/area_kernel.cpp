// The paper's PDM on 1014 patches: all pairs of patches, five Gauss-Legendre nodes a side on each.

#include "core/estimators/pairs/area_kernel.hpp"

#include "core/geometry/box.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>

namespace {

using namespace ff;

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

}  // namespace

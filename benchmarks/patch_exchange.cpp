// Exact exchange areas of all pairs of patches: the paper's cube with 1014 patches, by closed form (along the axes) and
// by contour integrals (turned), and single pairs of triangles.

#include "core/exact/exact.hpp"

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace {

using namespace ff;

void cube_of_1014_patches(benchmark::State& state) {
    Scene cube = make_box(6, 6, 6);
    if (state.range(0) != 0) {
        const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
        for (Surface& surface : cube.surfaces) {
            Parallelogram& shape = parallelogram(surface);
            shape = {turn * shape.corner, turn * shape.edge_u, turn * shape.edge_v};
            surface.normal = turn * surface.normal;
        }
    }
    double error = 0;
    for (auto _ : state) {
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const auto exchange = patch_exchange(cube.surfaces[i], cube.surfaces[j], {13});
                benchmark::DoNotOptimize(exchange.areas.data());
                error = std::max(error, exchange.error / (36.0 / 169));
            }
        }
    }
    state.counters["error_of_F"] = error;
}
BENCHMARK(cube_of_1014_patches)->ArgName("turned")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void triangles(benchmark::State& state) {
    const Corners<double> from{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}};
    const bool touching = state.range(0) != 0;
    const Corners<double> to{{0, 0, touching ? 0 : 1.0}, {0.2, 1, 1}, {1, 0.3, 1.2}};
    for (auto _ : state) benchmark::DoNotOptimize(polygon_exchange_area<double>(from, to));
}
BENCHMARK(triangles)->ArgName("touching")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace

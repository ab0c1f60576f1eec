// Whole matrices with intervals, and what a sample of either kind costs.

#include "studies/form_factors/form_factors.hpp"
#include "core/geometry/scene.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/tracing/tracer.hpp"
#include "studies/form_factors/cells/cell_sum.hpp"
#include "studies/form_factors/row_by_rays.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace {

using namespace ff;

void form_factors(benchmark::State& state, const char* name, double tolerance) {
    const Scene scene = built_in_scene(name);
    studies::form_factors::Request request;
    request.tolerance = tolerance;
    studies::form_factors::Matrix matrix;
    for (auto _ : state) {
        matrix = studies::form_factors::find_matrix(scene, request);
        benchmark::DoNotOptimize(matrix.exchanges.data());
        ++request.seed.value;
    }
    state.counters["samples"] = static_cast<double>(matrix.samples);
    state.counters["missed"] = static_cast<double>(matrix.missed());
    state.counters["half_width"] = Eigen::MatrixXd(matrix.half_widths()).maxCoeff();
}
// A standard error of 1e-4 is a half width of 2.13e-4 with 15 degrees of freedom at 0.95.
BENCHMARK_CAPTURE(form_factors, squares_blocked, "squares_blocked", 2.13e-4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(form_factors, nested_cubes, "nested_cubes", 1e-5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(form_factors, coaxial_discs, "coaxial_discs_equal", 1e-4)->Unit(benchmark::kMillisecond);

/// A pair in cells, with the time of an evaluation.
void cells(benchmark::State& state, const char* name) {
    const Scene scene = built_in_scene(name);
    const studies::form_factors::FacePairs geometry = studies::form_factors::examine_pairs(scene, {});
    const auto pair =
        std::find_if(geometry.pairs.begin(), geometry.pairs.end(), [](const auto& p) { return p.by_cells; });
    const studies::form_factors::CellLimits limits{1e-6, 0.95, std::uint64_t{1} << 22};
    std::uint64_t evaluations = 0;
    for (auto _ : state) {
        const StreamKey key = derive_key(Seed{evaluations}, "cells");
        evaluations += studies::form_factors::cell_sum(scene, geometry, *pair, limits, key).evaluations;
    }
    state.counters["per_evaluation"] =
        benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["blockers"] = static_cast<double>(geometry.surfaces_of(*pair).front().blockers);
}
BENCHMARK_CAPTURE(cells, squares_blocked, "squares_blocked");
BENCHMARK_CAPTURE(cells, squares_through_aperture, "squares_through_aperture");
BENCHMARK_CAPTURE(cells, nested_cubes, "nested_cubes");

void a_ray(benchmark::State& state, const char* name) {
    const Scene scene = built_in_scene(name);
    studies::form_factors::Request request;
    request.cells = false;
    const studies::form_factors::FacePairs geometry = studies::form_factors::examine_pairs(scene, request);
    studies::form_factors::RowByRays row(scene, geometry, geometry.pairs.front().from, {0});
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    constexpr std::uint64_t rays = 65536;
    row.set_rays(rays);
    std::uint32_t round = 0;
    for (auto _ : state) row.run(*tracer, {}, round++ % studies::form_factors::randomisations, nullptr);
    state.counters["per_ray"] = benchmark::Counter(static_cast<double>(rays) * static_cast<double>(state.iterations()),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(a_ray, squares_blocked, "squares_blocked");
BENCHMARK_CAPTURE(a_ray, nested_cubes, "nested_cubes");
BENCHMARK_CAPTURE(a_ray, coaxial_discs, "coaxial_discs_equal");

}  // namespace

// One trial of ray shooting on the cube of the paper: 1014 patches x 625 rays, points, tracing and tallies.

#include "core/estimators/rays/ray_shooting.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/instruction_sets.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

namespace {

using namespace ff;

constexpr Subdivision subdivision{13};
constexpr Grid grid{13, 13};
constexpr std::uint64_t samples = 625;

void run_trials(benchmark::State& state, const char* sampler, TracerChoice choice) {
    const Scene scene = make_box(6, 6, 6);
    const auto tracer = make_tracer(scene, choice);
    const auto points = samplers::find(sampler).make({.points = samples});
    RayTally tally;
    PatchSums sums;
    std::uint32_t trial = 0;
    for (auto _ : state) {
        ray_shooting(scene, subdivision, *tracer, *points, samples, Allocation::patch, {1, 2}, trial++, tally, &sums);
        benchmark::DoNotOptimize(tally.hits.data());
    }
    state.counters["per_ray"] =
        benchmark::Counter(static_cast<double>(subdivision.patches(scene) * samples),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The tracer alone: one block of points, traced again and again from all patches.
void trace_only(benchmark::State& state) {
    const Scene scene = make_box(6, 6, 6);
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    PointBlock block;
    block.size = samples;
    samplers::find("random").make({.points = samples})->fill({.key = {1, 2}}, 0, block);
    FaceHits hits(7);
    for (auto _ : state) {
        for (std::uint32_t patch = 0; patch < subdivision.patches(scene); ++patch) {
            tracer->shoot(patch / grid.parts(), grid, patch % grid.parts(), block, hits);
        }
        benchmark::DoNotOptimize(hits.data());
    }
    state.counters["per_ray"] =
        benchmark::Counter(static_cast<double>(subdivision.patches(scene) * samples),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

const bool registered = [] {
    for (const char* sampler : {"random", "sobol", "stratified", "halton", "random_mt"}) {
        benchmark::RegisterBenchmark((std::string("trial/box/") + sampler).c_str(), run_trials, sampler,
                                     TracerChoice::box)
            ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark("trial/embree/random", run_trials, "random", TracerChoice::embree)
        ->Unit(benchmark::kMillisecond);
    for (const std::string& set : instruction_sets()) {
        benchmark::RegisterBenchmark(("trial/box/random/" + set).c_str(), [set](benchmark::State& state) {
            use_instruction_set(set);
            run_trials(state, "random", TracerChoice::box);
            use_instruction_set("");
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("box_tracer/" + set).c_str(), [set](benchmark::State& state) {
            use_instruction_set(set);
            trace_only(state);
            use_instruction_set("");
        })->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace

#include "stats/gates/gate.hpp"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

/// The cost of a gate in a unit test apart from its trials, here skewed ones, with a bias that makes it pass or fail.
void gate_of_mean(benchmark::State& state, double bias) {
    std::mt19937_64 engine(1);
    std::gamma_distribution<double> gamma(4);
    std::vector<double> values(static_cast<std::size_t>(state.range(0)));
    for (double& value : values) value = gamma(engine) + bias;
    const ff::gate::Options options{.band = 1};
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(ff::gate::mean(values, 4.0, options));
}
BENCHMARK_CAPTURE(gate_of_mean, passes, 0.0)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(gate_of_mean, fails, 3.0)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace

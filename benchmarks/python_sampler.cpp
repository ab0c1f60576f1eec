#include "benchmarks/fill_sets.hpp"
#include "python/module/module.hpp"

#include "samplers/outside/added.hpp"

#include <benchmark/benchmark.h>
#include <pybind11/embed.h>

#include <cstdint>
#include <string>
#include <thread>

// The total time of a sampler that is a Python function, and that of making its arrays alone: the random points of
// NumPy, the cheapest ones, and the lattice of docs/python.md. Then a sampler that always returns the same array, which
// leaves only calling, checking and copying.

namespace {

namespace py = pybind11;
using namespace ff;

constexpr auto functions = R"(
import functools
import numpy

def random(n, d, seed, trial):
    return numpy.random.default_rng(seed).random((n, d))

def lattice(n, d, seed, trial):
    generator = numpy.array([pow(1571, j, n) for j in range(d)])
    return (numpy.outer(numpy.arange(n), generator) / n + numpy.random.default_rng(seed).random(d)) % 1

@functools.lru_cache(maxsize=1)
def points(n, d):
    return numpy.random.default_rng(1).random((n, d))

def same(n, d, seed, trial):
    return points(n, d)
)";

/// Runs work on a thread of ours, as studies call functions.
template <class Work>
void run_beside_python(Work work) {
    const py::gil_scoped_release released;
    std::thread(work).join();
}

void whole(benchmark::State& state, const std::string& name) {
    const auto source =
        samplers::find_added("numpy_" + name)->make({.points = static_cast<std::uint64_t>(state.range(0))});
    run_beside_python([&] { fill_sets<PointBlock>(state, *source); });
}

void alone(benchmark::State& state, const std::string& name) {
    const py::object function = py::globals()[name.c_str()];
    std::uint64_t seed = 0;
    for (auto _ : state) benchmark::DoNotOptimize(py::object(function(state.range(0), 4, ++seed, 0)).ptr());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->RangeMultiplier(4)->Range(1024, 65536)->MeasureProcessCPUTime();
}

BENCHMARK_CAPTURE(whole, random, std::string("random"))->Apply(sizes);
BENCHMARK_CAPTURE(alone, random, std::string("random"))->Apply(sizes);
BENCHMARK_CAPTURE(whole, lattice, std::string("lattice"))->Apply(sizes);
BENCHMARK_CAPTURE(alone, lattice, std::string("lattice"))->Apply(sizes);
BENCHMARK_CAPTURE(whole, same, std::string("same"))->Apply(sizes);
BENCHMARK_CAPTURE(alone, same, std::string("same"))->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape): ends the program with its message
    const py::scoped_interpreter interpreter;
    py::exec(functions);
    for (const std::string name : {"random", "lattice", "same"})
        python::add_function("numpy_" + name, "benchmark", py::globals()[name.c_str()], 4, true);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}

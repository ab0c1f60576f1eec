#pragma once

#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

namespace ff {

/// Fills a whole set block by block, with a new stream (and so a new randomisation) every time.
template <class Block>
void fill_sets(benchmark::State& state, const PointSource& source) {
    Stream stream{.key = {1, 2}};
    Block block;
    for (auto _ : state) {
        ++stream.source;
        for_each_block(source, stream, 0, source.points(), block, [&](PointIndex) {
            benchmark::DoNotOptimize(block.coordinate[0][0]);
            benchmark::ClobberMemory();
        });
    }
    state.counters["per_point"] =
        benchmark::Counter(static_cast<double>(source.points()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace ff

#pragma once

#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace ff {

/// Fills a whole set block by block, with a new stream (and so a new randomisation) every time.
template <class Block>
void fill_sets(benchmark::State& state, const PointSource& source) {
    Stream stream{.key = {1, 2}};
    Block block;
    for (auto _ : state) {
        ++stream.source;
        for (PointIndex first = 0; first < source.points(); first += block.size) {
            block.size = std::min<std::size_t>(block_capacity, source.points() - first);
            source.fill(stream, first, block);
            benchmark::DoNotOptimize(block.coordinate[0][0]);
            benchmark::ClobberMemory();
        }
    }
    state.counters["per_point"] =
        benchmark::Counter(static_cast<double>(source.points()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace ff

#include "tests/validation/rates/repetitions.hpp"

#include "stats/basics/distributions.hpp"
#include "studies/run/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {

std::vector<double> Repetitions::collect(std::uint64_t times, std::string_view what,
                                         const std::function<double(stats::Draws&)>& experiment) const {
    const StreamKey key = derive_key(seed, what);
    std::vector<double> results(times);
    for_each_index(times, threads, [&](std::uint64_t i) {
        stats::Draws draws(key, stats::Resampling::simulation, static_cast<std::uint32_t>(i));
        results[i] = experiment(draws);
    });
    return results;
}

stats::Proportion Repetitions::count(std::uint64_t times, std::string_view what,
                                     const std::function<bool(stats::Draws&)>& event) const {
    const auto results = collect(times, what, [&](stats::Draws& draws) { return event(draws) ? 1.0 : 0.0; });
    return {.hits = static_cast<std::uint64_t>(std::count(results.begin(), results.end(), 1.0)), .trials = times};
}

double draw_normal(stats::Draws& draws) {
    return stats::normal_critical(std::max(draws.uniform(), 0x1p-54));
}

double draw_exponential(stats::Draws& draws) {
    return -std::log1p(-draws.uniform());
}

}  // namespace ff::studies

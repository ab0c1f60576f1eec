#include "studies/selftest/repetitions.hpp"

#include "core/error.hpp"
#include "stats/distributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace ff::studies {

void for_each_index(std::uint64_t times, unsigned threads, const std::function<void(std::uint64_t)>& task) {
    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            for (std::uint64_t i = next++; i < times; i = next++) task(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            next = times;
        }
    };
    std::vector<std::jthread> pool;
    try {
        while (pool.size() + 1 < threads) pool.emplace_back(work);
    } catch (const std::system_error& error) {
        next = times;
        throw UserError(fmt::format("{} threads (the system started {} of them: {}). Take fewer with --threads.",
                                    threads, pool.size(), error.code().message()));
    }
    work();
    pool.clear();  // joins them
    if (failure) std::rethrow_exception(failure);
}

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

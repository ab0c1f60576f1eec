#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace ff::test {

/// The samples that numbers from other programs refer to in the comments of the tests that compare with them.
inline constexpr std::array eight_values{2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3};

/// `n` values of a distribution of the standard library, from an engine that the caller seeds.
template <class Distribution>
std::vector<double> sample(Distribution distribution, std::size_t n, std::mt19937_64& engine) {
    std::vector<double> values(n);
    for (double& value : values) value = distribution(engine);
    return values;
}

inline std::vector<double> normal_sample(std::size_t n, std::mt19937_64& engine, double mean = 0, double sigma = 1) {
    return sample(std::normal_distribution<double>(mean, sigma), n, engine);
}

/// How often `event()` is true in `trials` calls.
template <class Event>
std::uint64_t count_events(std::uint64_t trials, Event event) {
    std::uint64_t hits = 0;
    for (std::uint64_t i = 0; i < trials; ++i) hits += event() ? 1u : 0u;
    return hits;
}

}  // namespace ff::test

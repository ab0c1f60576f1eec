#pragma once

#include "core/points/stream.hpp"
#include "stats/basics/binomial.hpp"
#include "stats/basics/resampling.hpp"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Independent repetitions of an experiment, spread over threads. Results do not depend on their number.
struct Repetitions {
    Seed seed;
    unsigned threads = 1;

    /// How often `event` is true; it receives the random numbers of one repetition and is called on several threads.
    [[nodiscard]] stats::Proportion count(std::uint64_t times, std::string_view what,
                                          const std::function<bool(stats::Draws&)>& event) const;

    /// The result of each repetition, in order.
    [[nodiscard]] std::vector<double> collect(std::uint64_t times, std::string_view what,
                                              const std::function<double(stats::Draws&)>& experiment) const;
};

/// A standard normal number.
double draw_normal(stats::Draws& draws);

/// An exponential number with mean 1.
double draw_exponential(stats::Draws& draws);

}  // namespace ff::studies

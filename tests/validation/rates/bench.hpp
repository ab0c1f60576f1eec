#pragma once

#include "tests/validation/rates/measured_rate.hpp"
#include "tests/validation/rates/repetitions.hpp"

#include <cstdint>
#include <string>

namespace ff::studies {

/// The level of most gates that are checked.
inline constexpr double usual_alpha = 0.01;

/// A band far narrower than the noise: a point null hypothesis.
inline constexpr double narrow_band = 1e-4;
/// The same for means of many trials, whose noise is small itself.
inline constexpr double narrowest_band = 1e-12;

/// Adds rates to a table, each from the same number of repetitions.
struct Bench {
    const Repetitions& repetitions;
    std::uint64_t times;
    RateTable& table;

    template <class Event>
    void add(const std::string& what, RateClaim claim, double claimed, const Event& event) const {
        table.rates.push_back({what, repetitions.count(times, what, event), claim, claimed});
    }
};

}  // namespace ff::studies

#pragma once

#include "studies/selftest/measured_rate.hpp"
#include "studies/selftest/repetitions.hpp"

#include <cstdint>
#include <string>

namespace ff::studies {

/// A band far narrower than the noise: a point null hypothesis.
inline constexpr double narrow_band = 1e-4;

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

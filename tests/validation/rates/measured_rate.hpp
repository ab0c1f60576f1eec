#pragma once

#include "stats/basics/binomial.hpp"
#include "stats/basics/interval.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::studies {

/// The claim about a rate.
enum class RateClaim {
    equal,
    at_most,
    at_least,
    none,  ///< shown for comparison
};

/// The frequency of an event among independent repetitions, beside the claimed one.
struct MeasuredRate {
    std::string what;
    stats::Proportion counts;
    RateClaim claim = RateClaim::equal;
    double claimed = 0;  ///< meaningless for RateClaim::none
};

/// Clopper-Pearson.
stats::Interval interval_of(const MeasuredRate& rate, double level);

/// The probability of counts that contradict the claim as much as these if the rate is exactly the claimed one: how
/// near they are to the limit of the claim. Infinite for a claim of `none`.
double tail_of(const MeasuredRate& rate);

/// Whether the claim is compatible with the interval. A claim of `none` always is.
bool holds(const MeasuredRate& rate, double level);

/// Rates that belong together, with their subject.
struct RateTable {
    std::string title;
    std::string text;  ///< a sentence or two above the table
    std::vector<MeasuredRate> rates;

    [[nodiscard]] std::size_t claims() const;
    [[nodiscard]] std::size_t contradictions(double level) const;  ///< claims that the intervals exclude
};

}  // namespace ff::studies

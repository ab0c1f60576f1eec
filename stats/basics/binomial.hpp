#pragma once

#include "stats/basics/interval.hpp"

#include <cstdint>

namespace ff::stats {

/// Hits among independent trials. Hits of stratified or quasi-random rays are not binomial: use replicates for them.
struct Proportion {
    std::uint64_t hits = 0;
    std::uint64_t trials = 0;

    /// @pre trials >= 1
    [[nodiscard]] double share() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

/// Clopper-Pearson interval for a hit probability: actual coverage >= level for every p.
/// @pre hits <= trials, trials >= 1, 0 < level < 1
/// @return bounds in [0, 1]; low is 0 without hits, high is 1 without misses       @see [clopper1934]
Interval clopper_pearson_interval(Proportion counts, double level);

/// Wilson's score interval: coverage near the level on average over p, at times a little below. @see [wilson1927]
Interval wilson_interval(Proportion counts, double level);

/// p +- z sqrt(p(1-p)/n): wrong for rare hits (coverage .46 at n = 625, p = .001); for comparison only.
/// @see [brown2001]
Interval wald_interval(Proportion counts, double level);

/// Exact two-sided p-value of "the hit probability is `probability`": the total probability of all outcomes at most as
/// likely as the one seen. @pre 0 <= probability <= 1
double binomial_two_sided_p(Proportion counts, double probability);

/// P(at least `hits`) at the given probability.
double binomial_upper_p(Proportion counts, double probability);
/// P(at most `hits`) at the given probability.
double binomial_lower_p(Proportion counts, double probability);

}  // namespace ff::stats

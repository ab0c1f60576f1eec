#pragma once

#include "stats/basics/binomial.hpp"
#include "stats/basics/interval.hpp"

#include <limits>
#include <optional>
#include <span>

namespace ff::stats {

/// The reference for the probability behind a share: a number, which may have a standard error, or another share.
struct ShareReference {
    double value = 0;
    double standard_error = 0;                                 ///< 0: exact
    double freedom = std::numeric_limits<double>::infinity();  ///< degrees of freedom of `standard_error`
    std::optional<Proportion> counts = {};                     ///< the other share; the members above are unused then
};

/// P-value of "the probability behind `counts` exceeds the reference by at most `difference`": the binomial tail where
/// the reference is exact [clopper1934]. An uncertain reference gets half of the error rate, so that the p-value is
/// twice the tail at which the limits of both meet: it holds for all probabilities, and may be larger than it need be.
/// @pre counts.trials >= 1
double p_of_at_most(Proportion counts, const ShareReference& reference, double difference);

/// P-value of "it exceeds the reference by at least `difference`".
double p_of_at_least(Proportion counts, const ShareReference& reference, double difference);

/// The values of `difference` that neither p-value rejects at (1 - level) / 2.
Interval share_difference_interval(Proportion counts, const ShareReference& reference, double level);

/// Confidence interval for an uncertain reference alone.
Interval reference_interval(const ShareReference& reference, double level);

/// P-value of "the hits of these runs scatter as those of independent trials with one probability do", against more
/// scatter: by the index of dispersion where 5 hits and 5 misses or more are expected of each run, and by the fullest
/// run where they are fewer. @pre at least one run
double p_of_binomial_scatter(std::span<const Proportion> runs);

}  // namespace ff::stats

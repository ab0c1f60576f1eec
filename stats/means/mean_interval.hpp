#pragma once

#include "stats/basics/interval.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"

#include <optional>
#include <span>

namespace ff::stats {

/// Intervals for the mean of independent replicates. All are empty below two values and where all values are equal: the
/// absence of spread is not evidence of precision.

/// Student's t: mean +- t(n-1) s / sqrt(n). The one to use; good from five replicates of a randomised rule on.
/// @see [lecuyer2023], [owen2025]
std::optional<Interval> mean_interval_t(const Moments& moments, double level);

/// Student's t for mean - reference, without cancellation.
std::optional<Interval> bias_interval_t(const Moments& moments, double level);

/// Normal quantiles in place of Student's: too narrow below some 30 replicates (for comparison).
std::optional<Interval> mean_interval_normal(const Moments& moments, double level);

/// Percentile bootstrap: much too narrow for few replicates (for comparison).
std::optional<Interval> mean_interval_bootstrap(std::span<const double> values, double level,
                                                const ResamplingPlan& plan);

/// Confidence sequences: intervals for a mean after any number of values, which all contain it together with a
/// probability of the level. So one may look after every value and stop at any time.

/// For independent normal values of any variance: the means whose Bayes factor against a normal effect size stays below
/// 1 / (1 - level). The factor is a martingale under each mean, whatever the variance is, so that Ville's inequality
/// holds [lai1976], [wang2023]. Infinite where there are too few values for the level.
/// @param tightest_at  number of values at which it is narrowest, chosen before any is seen @pre level in (0, 1)
Interval normal_sequence(std::span<const double> values, double tightest_at, double level);

/// For values between two bounds with the same mean given all earlier ones: the empirical Bernstein sequence with
/// predictable weights [waudby2024], intersected over all values so far. It assumes nothing else of the distribution.
/// @pre low < high, and all values lie between
Interval bounded_sequence(std::span<const double> values, double low, double high, double level);

}  // namespace ff::stats

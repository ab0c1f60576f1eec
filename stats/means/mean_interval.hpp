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

}  // namespace ff::stats

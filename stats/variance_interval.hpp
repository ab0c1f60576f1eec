#pragma once

#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats/resampling.hpp"

#include <optional>
#include <span>

namespace ff::stats {

/// Intervals for the variance of independent replicates; empty for too few values and for values that are all equal.

/// Chi-squared interval, exact for normal data only; its coverage does not get better with n for other kurtosis.
/// Empty below two values.
std::optional<Interval> variance_interval_chi2(const Moments& moments, double level);

/// Seeded bootstrap of the log variance; needs eight values.
std::optional<Interval> variance_interval_bootstrap(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

/// Chi-squared where kurtosis allows, else bootstrap; `method` says which.
std::optional<Interval> variance_interval(std::span<const double> values, double level, const ResamplingPlan& plan);

/// Square root of `variance_interval`.
std::optional<Interval> standard_deviation_interval(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

}  // namespace ff::stats

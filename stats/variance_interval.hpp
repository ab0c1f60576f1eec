#pragma once

#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats/resampling.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Intervals for the variance of independent replicates; empty for too few values and for values that are all equal.

/// Chi-squared interval, exact for normal data only; its coverage does not get better with n for other kurtosis.
/// Empty below two values.
std::optional<Interval> variance_interval_chi2(const Moments& moments, double level);

/// Fewer values resample too coarsely for `variance_interval_bootstrap`.
inline constexpr std::size_t fewest_for_variance_bootstrap = 8;

/// Seeded studentised bootstrap of the log variance, with the standard error sqrt((excess kurtosis + 2) / n) of each
/// resample. Measured coverage at nominal .95, n = 30 and 100: normal .94 and .94, Laplace .94 and .95, exponential .89
/// and .95, Student t(5) .94 and .93. Percentile and BCa intervals were worse everywhere (exponential, n = 30: .73,
/// .79). Empty below `fewest_for_variance_bootstrap` values or where they take two values half each.
std::optional<Interval> variance_interval_bootstrap(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

/// Chi-squared where the sample's excess kurtosis G2 lies within two of its standard errors (for normal data) of 0 or
/// there are too few values to resample; else the bootstrap. `method` says which.
std::optional<Interval> variance_interval(std::span<const double> values, double level, const ResamplingPlan& plan);

/// Square root of `variance_interval`.
std::optional<Interval> standard_deviation_interval(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

}  // namespace ff::stats

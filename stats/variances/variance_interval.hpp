#pragma once

#include "stats/basics/interval.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Intervals for the variance of independent replicates; empty for too few values and for values that are all equal.

/// Chi-squared interval, exact for normal data only; its coverage does not get better with n for other kurtosis.
/// Empty below two values.
std::optional<Interval> variance_interval_chi2(const Moments& moments, double level);

/// Fewest values that `variance_interval_bootstrap` can resample.
inline constexpr std::size_t fewest_for_variance_bootstrap = 8;

/// Where fewer values (or fewer than half of them) differ from the most frequent one, there is no interval at all: a
/// few hits among a thousand trials tell little about the variance, and a resample without any of them tells nothing.
/// Measured coverage of one hit in 10, 4 or 2 trials, for n = 100, at nominal .95: .96 .97 1.
inline constexpr std::size_t fewest_deviating_values = 7;

/// Seeded studentised bootstrap of the log variance, with the standard error sqrt((excess kurtosis + 2) / n) of each
/// resample. Coverage measured at nominal .95 for n = 10, 30, 100, 1000 (+-.01): normal .93 .94 .95 .94, Laplace .89
/// .91 .93 .94, exponential .85 .91 .91 .96. Percentile and BCa intervals covered less at n = 10 to 100 (exponential, n
/// = 30: .73 and .79). Empty below `fewest_for_variance_bootstrap` values or where they take two values half each.
std::optional<Interval> variance_interval_bootstrap(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

/// From this many values on their kurtosis is known well enough, and the bootstrap would take seconds.
inline constexpr std::size_t enough_for_kurtosis = 5000;

/// Chi-squared where the sample's excess kurtosis G2 lies within two of its standard errors (for normal data) of 0 or
/// below -1.5, or there are too few values to resample; else the bootstrap, or, from `enough_for_kurtosis` values on,
/// chi-squared with degrees of freedom reduced for their kurtosis (stats/variances/spread.hpp). `method` says which.
/// Few values do not show their kurtosis: measured coverage for Laplace data is .86 .87 .92 .94 (n as above), for
/// normal data at least .95.
std::optional<Interval> variance_interval(std::span<const double> values, double level, const ResamplingPlan& plan);

/// Square root of `variance_interval`.
std::optional<Interval> standard_deviation_interval(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan);

}  // namespace ff::stats

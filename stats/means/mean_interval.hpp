#pragma once

#include "stats/basics/interval.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"
#include "stats/gates/skewed_reach.hpp"

#include <cstddef>
#include <cstdint>
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

/// The sequence for independent normal values of any variance: the means whose Bayes factor against a normal effect
/// size stays below 1 / (1 - level). The factor is a martingale under each mean, whatever the variance is, so that
/// Ville's inequality holds [lai1976], [wang2023]. Infinite where there are too few values for the level.
/// @param tightest_at  number of values at which it is narrowest, chosen before any is seen @pre level in (0, 1)
Interval normal_sequence(std::span<const double> values, double tightest_at, double level);

/// The sequence for values between two bounds with the same mean given all earlier ones: empirical Bernstein with
/// predictable weights [waudby2024], intersected over all values so far. It assumes nothing else of the distribution.
/// @pre low < high, and all values lie between
Interval bounded_sequence(std::span<const double> values, double low, double high, double level);

/// Stein's two stages [stein1945]: the spread of the first values, the pilot, fixes the total number n. For normal
/// values the mean of all n is independent of that spread, so that sqrt(n) (mean - truth) / s of the pilot has exactly
/// Student's t distribution with the pilot's degrees of freedom: intervals keep their coverage although n was chosen by
/// looking at the data. Intervals with the standard deviation of all values do not keep it.
struct Pilot {
    std::size_t n = 0;              ///< values, >= 2
    double standard_deviation = 0;  ///< sample standard deviation of the pilot alone, > 0
    gate::MeanSkewness skewness;    ///< skewness of the pilot's mean, as far as the law may be skewed

    [[nodiscard]] double freedom() const { return static_cast<double>(n - 1); }
    /// The skewness of a mean of `trials` values of the same law.
    [[nodiscard]] gate::MeanSkewness skewness_at(std::uint64_t trials) const;
};

/// The first n of the values, which are taken to be normal; empty where they do not vary or are fewer. @pre n >= 2
std::optional<Pilot> pilot_of(std::span<const double> values, std::size_t n);

/// The same for values that may be skewed, as far as their largest part allows (stats/means/mean_test.hpp). @pre n >= 3
std::optional<Pilot> skewed_pilot_of(std::span<const double> values, std::size_t n, double largest_part);

/// Half-width of the interval of a mean of `trials` values: t(n - 1) s / sqrt(trials), or as far as skewness may reach
/// (stats/gates/skewed_reach.hpp) on the longer side. @pre trials >= pilot.n
double half_width_of(Pilot pilot, std::uint64_t trials, double level);

/// Upper bound, on average over pilots, of the root mean squared error of a mean of `trials` values: s sqrt((n - 1) /
/// (n - 3) / trials), since E(sigma^2 / s^2) = (n - 1) / (n - 3) for n normal values.
/// @pre pilot.n >= 4, trials >= pilot.n
double rmse_of(Pilot pilot, std::uint64_t trials);

/// Total number of values for a half-width of at most `half_width`, at least the pilot's.
/// @pre half_width > 0
std::uint64_t trials_for_half_width(Pilot pilot, double half_width, double level);

/// Total number of values for a root mean squared error of the mean of at most `rmse`. @pre pilot.n >= 4, rmse > 0
std::uint64_t trials_for_rmse(Pilot pilot, double rmse);

}  // namespace ff::stats

#pragma once

#include "stats/basics/binomial.hpp"
#include "stats/convergence/convergence.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/variance_interval.hpp"
#include "studies/verdicts/verdict.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace ff::studies::gates {

/// How each kind of effect is measured. Numbers in, numbers out: nothing here knows where the values come from. Empty
/// where the values do not support an interval (too few, or all equal).

/// The reference of a mean.
struct MeanReference {
    double value = 0;
    double standard_error = 0;                                 ///< 0 for an exact value
    double freedom = std::numeric_limits<double>::infinity();  ///< degrees of freedom of `standard_error`
    gate::MeanSkewness skewness{.most = stats::no_part};       ///< of the mean that the reference is
};

/// Mean minus reference by the rule for means (stats/means/mean_test.hpp).
/// @param limits       of the values
/// @param correlation  of the values in order; by default that of independent ones
std::optional<Measurement> measure_mean(std::span<const double> values, const MeanReference& reference,
                                        const Band& band, const Levels& levels, const stats::KnownLimits& limits = {},
                                        const std::optional<stats::Autocorrelation>& correlation = {});

/// Root of a mean square (standard deviation or RMSE) over a known one, > 0.
Measurement measure_spread(const stats::MeanSquare& spread, double reference, const Band& band, const Levels& levels);

/// Half the logarithm of the mean square about a centre, by the rule for means; empty where there is none.
/// @param unmet_squares  the part of it that evaluations behind the values may all have missed
std::optional<stats::Measured> logarithm_of_spread(std::span<const double> values, double centre,
                                                   const stats::Unmet& unmet_squares = {});

/// The same of trials, at least as long as the rule for means makes the interval of the mean square behind it.
/// @param logarithm  of the same values
Measurement measure_spread(const stats::MeanSquare& spread, stats::Measured logarithm, double reference,
                           const Band& band, const Levels& levels);

/// Root mean square over that of an independent sample.
Measurement measure_spread(const stats::MeanSquare& spread, const stats::MeanSquare& reference, const Band& band,
                           const Levels& levels);

/// The probability behind independent trials, by Clopper and Pearson. @pre counts.trials >= 1
Measurement measure_proportion(const stats::Proportion& counts, const Band& band, const Levels& levels);

/// Rate of the RMSE along a ladder.
std::optional<Measurement> measure_slope(std::span<const stats::Rung> ladder, const Band& band, const Levels& levels);

/// Widens both intervals to what the rule for means says of the number, or of its logarithm, and the detectable effect
/// with them: the others rest on variances of squares that few trials may not show.
void allow_for_skewness(Measurement& measurement, const stats::Measured& number, bool is_logarithm, const Band& band,
                        const Levels& levels);

/// A deterministic value: one evaluation decides.
Measurement measure_exactly(double value, const Band& band);

/// Trials per look with which a gate without effect passes all its comparisons together with the power of `levels`:
/// each may fail with probability (1 - power) / comparisons. Empty where no number of trials is enough.

/// A mean, normal or nearly so. With skewness g the t interval's error rate at fail_alpha is off by a factor of about
/// exp(z^3 g / (3 sqrt(T))); trials are added until it is below 2.
/// @param sigma  of a trial, >= 0 @param reference_se standard error of the reference
/// @param half_width  of the band around 0, > 0
std::optional<std::uint64_t> trials_for_mean(double half_width, double sigma, double skewness, double reference_se,
                                             const Levels& levels, std::size_t comparisons);

/// Whether such a number exists, which is faster to decide.
bool can_decide_mean(double half_width, double sigma, double reference_se, const Levels& levels,
                     std::size_t comparisons);

/// Runs of another program that are needed for their mean, whose standard errors are as stated.
/// @param error  of one run, >= 0
std::optional<std::uint64_t> runs_for_mean(double half_width, double error, double reference_se, const Levels& levels,
                                           std::size_t comparisons);

/// A ratio of standard deviations; 1 lies inside the band.
/// @param excess_kurtosis  of a trial     @param reference_freedom  infinite for an exact reference
std::optional<std::uint64_t> trials_for_ratio(const Band& band, double excess_kurtosis, double reference_freedom,
                                              const Levels& levels, std::size_t comparisons);

/// A probability, by Clopper-Pearson intervals. @pre band.low < probability < band.high, or band.high == 1
std::optional<std::uint64_t> trials_for_proportion(const Band& band, double probability, const Levels& levels,
                                                   std::size_t comparisons);

/// A slope in the middle of the band, from the same number of trials at each of `sizes`.
/// @param kurtosis_factor  by which the variances of normal errors are multiplied, >= 1
std::optional<std::uint64_t> trials_for_slope(const Band& band, std::span<const double> sizes, double kurtosis_factor,
                                              const Levels& levels, std::size_t comparisons);

/// Number of rays of which, with the given power, at least one is lost if a share `rate` is.
double rays_for_loss(double rate, const Levels& levels);

}  // namespace ff::studies::gates

#pragma once

#include "studies/verdicts/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace ff::studies::gates {

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

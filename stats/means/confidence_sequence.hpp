#pragma once

#include "stats/basics/interval.hpp"

#include <span>

namespace ff::stats {

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

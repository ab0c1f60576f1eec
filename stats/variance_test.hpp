#pragma once

#include "stats/resampling.hpp"

#include <optional>
#include <span>

namespace ff::stats {

/// Two samples' variances compared. Neither test assumes normal data (the F test does, and fails under kurtosis).
struct VarianceTest {
    double ratio = 0;      ///< variance of the first over that of the second
    double statistic = 0;  ///< F (Brown-Forsythe) or ln ratio (permutation)
    double p = 0;          ///< two-sided
};

/// Brown-Forsythe: analysis of variance of |x - median|. Empty below three values in a sample or where neither spreads.
/// @see [brown1974]
std::optional<VarianceTest> test_variances_brown_forsythe(std::span<const double> a, std::span<const double> b);

/// Permutation test of ln(var a / var b) on data centred at their own means; p = (1 + extreme) / (1 + replicates).
/// Empty below three values in a sample or where one does not spread.
std::optional<VarianceTest> test_variances_permutation(std::span<const double> a, std::span<const double> b,
                                                       const ResamplingPlan& plan);

}  // namespace ff::stats

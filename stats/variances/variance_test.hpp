#pragma once

#include <optional>
#include <span>

namespace ff::stats {

/// Compares two samples' variances without assuming normal data (the F test does, and fails under kurtosis).
struct VarianceTest {
    double ratio = 0;      ///< variance of the first over that of the second
    double statistic = 0;  ///< F
    double p = 0;          ///< two-sided
};

/// Brown-Forsythe: analysis of variance of |x - median|. Empty below three values in a sample or where neither varies.
/// @see [brown1974]
std::optional<VarianceTest> test_variances_brown_forsythe(std::span<const double> a, std::span<const double> b);

}  // namespace ff::stats

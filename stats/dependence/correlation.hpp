#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Test of "the values are independent of those before them".
struct SerialTest {
    double first = 0;       ///< autocorrelation at lag 1
    std::size_t lags = 0;   ///< number of lags that Ljung and Box sum over
    double statistic = 0;   ///< Ljung and Box's
    double p = 0;           ///< twice the smaller p-value of the two tests
    double detectable = 0;  ///< autocorrelation at lag 1 that is detected with probability 0.9 at alpha 0.05
};

/// Two tests under one p-value (Bonferroni): for positive correlation at lag 1, which chains and shared states cause
/// [vonneumann1941], and for any correlation up to lag 10 [ljung1978]. P-values below 0.01 are at least the share of
/// random orders of the values that look as dependent, so that they hold for any distribution and few values. Empty
/// below `fewest_for_serial_test` values and where all are equal.
std::optional<SerialTest> test_serial_correlation(std::span<const double> values);

inline constexpr std::size_t fewest_for_serial_test = 10;

/// How far a series is from independent values.
struct Autocorrelation {
    /// Integrated autocorrelation time 1 + 2 sum r_k: the variance of the mean is this many times that of independent
    /// values, which are worth n / time. At least 1.
    double time = 1;
    double freedom = 0;  ///< degrees of freedom of the variance of the mean; n where the time is 1
};

/// Summed while pairs of successive autocorrelations are positive and fall (initial monotone sequence [geyer1992]), and
/// corrected for the mean's own share, which hides correlation in short series. @pre values are not all equal
Autocorrelation autocorrelation_of(std::span<const double> values);

/// P-value of "these variables are independent of each other", against any correlation between them, however many they
/// are: by the sum of all squared correlation coefficients [schott2005], whose distribution is taken to be that of a
/// multiple of chi-squared with the same mean and variance. For normal values; no variance needs to be known. Takes
/// time proportional to the number of values times that of repetitions.
/// @param values  all repetitions of the first variable, then those of the next
/// @return empty with fewer than 4 repetitions, or fewer than 2 variables that vary
std::optional<double> p_of_independence(std::span<const double> values, std::size_t repetitions);

/// Kendall's tau-b of two series: 1 where they have the same order, -1 where they have opposite ones.
struct RankCorrelation {
    double tau = 0;
    /// All tau within the normal quantile times the largest possible standard deviation, sqrt(2 (1 - tau²) / n), of the
    /// observed one, whatever the distribution [kendall1970].
    Interval interval;
};

/// Fewer pairs of values tell next to nothing.
inline constexpr std::size_t fewest_ranked = 6;

/// Empty for fewer than `fewest_ranked` values, and where all values of one series are equal.
/// @pre both are equally long  @param level  level of the interval
std::optional<RankCorrelation> rank_correlation(std::span<const double> first, std::span<const double> second,
                                                double level);

}  // namespace ff::stats

#pragma once

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

}  // namespace ff::stats

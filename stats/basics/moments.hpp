#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Count, mean and central moments up to the fourth of a stream of numbers, in one pass (Welford, Pebay
/// [pebay2008]).
///
/// Everything is kept relative to `reference`, usually the exact value: a bias far below the mean, or a variance of
/// 1e-24 beside a mean of 0.2, survives. Results are equal to the bit for the same values in the same order; another
/// order changes the last digits.
class Moments {
  public:
    /// @param reference  what offsets are measured from, e.g. the exact form factor
    explicit Moments(double reference = 0) : reference_(reference) {}

    void add(double value);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] double reference() const { return reference_; }

    /// Mean; empty without values.
    [[nodiscard]] std::optional<double> mean() const;
    /// Mean minus reference without cancellation: the estimated bias. Empty without values.
    [[nodiscard]] std::optional<double> bias() const;

    /// Unbiased variance (divisor n - 1), exactly 0 for equal values; empty below two values.
    [[nodiscard]] std::optional<double> variance() const;
    [[nodiscard]] std::optional<double> standard_deviation() const;
    /// Standard error of the mean: s / sqrt(n); empty below two values.
    [[nodiscard]] std::optional<double> standard_error() const;
    /// Mean of (value - reference)^2 (divisor n); empty without values.
    [[nodiscard]] std::optional<double> mean_squared_error() const;
    [[nodiscard]] std::optional<double> root_mean_squared_error() const;

    /// Adjusted Fisher-Pearson skewness G1 [joanes1998]; empty below three values or for equal values.
    [[nodiscard]] std::optional<double> skewness() const;
    /// Excess kurtosis G2 [joanes1998], unbiased (0) for normal data; empty below four values or for equal values.
    [[nodiscard]] std::optional<double> excess_kurtosis() const;
    /// Variance of the variance, relative: sum (x-m)^4 / (sum (x-m)^2)^2 - 1/n [pederson1997]. Below 0.1 in a healthy
    /// tally and falling as 1/n. Empty below two values or for equal values.
    [[nodiscard]] std::optional<double> variance_of_variance() const;

  private:
    double reference_;
    std::size_t count_ = 0;
    double offset_ = 0;                      // mean - reference
    double sum2_ = 0, sum3_ = 0, sum4_ = 0;  // sums of powers of (value - mean)
};

/// Moments of `values`, added in order.
Moments moments_of(std::span<const double> values, double reference = 0);

/// Standard error of G1 for n normal values; empty below three. @see [joanes1998]
std::optional<double> skewness_standard_error(std::size_t n);
/// Standard error of G2 for n normal values; empty below four. @see [joanes1998]
std::optional<double> excess_kurtosis_standard_error(std::size_t n);

}  // namespace ff::stats

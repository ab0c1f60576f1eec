#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// How heavy the upper tail is: P(X > x) ~ x^-index. The variance is infinite for an index below 2, the mean for one
/// below 1. (MCNP's tail slope is index + 1.)
struct TailFit {
    double shape = 0;           ///< xi of the generalised Pareto distribution: 1 / index; <= 0 for light tails
    double standard_error = 0;  ///< error of shape: (1 + shape) / sqrt(exceedances); Hill's: shape / sqrt(exceedances)
    double error_at_two = 0;    ///< the standard error for an index of 2

    /// 1 / shape; empty where shape <= 0 (lighter than any power).
    [[nodiscard]] std::optional<double> index() const { return shape > 0 ? std::optional(1 / shape) : std::nullopt; }
};

/// Generalised Pareto fit (Zhang and Stephens [zhang2009]) to the values above the (1 - fraction) quantile. Invariant
/// under shift and scale. Empty below 20 exceedances or where they are all equal.
std::optional<TailFit> fit_tail(std::span<const double> values, double fraction = 0.1);

/// Hill's estimate of 1 / index from the `exceedances` largest positive values [hill1975]; sensitive to shift. Empty
/// unless more than `exceedances` >= 2 values are positive.
std::optional<TailFit> fit_tail_hill(std::span<const double> values, std::size_t exceedances);

/// The finding about the variance that a tail supports.
enum class VarianceHealth { finite, infinite, undecided };

/// Tests the index 2, at which the variance just becomes infinite: infinite where the index is significantly below 2,
/// finite where it is significantly above (one-sided, `alpha` each; standard error at the index tested), otherwise
/// undecided. Measured for a tenth of 1000 values: index 1.5 called finite in none of 500 cases, normal data always
/// finite.
VarianceHealth judge_variance(const TailFit& fit, double alpha = 0.01);

/// Why no interval of a mean can be believed. No test is enough alone: tail indices need many values, and the variance
/// of the variance a large one among them.
struct TailDoubt {
    enum class Reason {
        infinite_variance,     ///< `value` is the tail index, significantly below 2
        not_shown_finite,      ///< there are many values, but the index is not shown to be above 2
        few_values_decide,     ///< `value` is the variance of the variance, above `limit`
        outer_tails_infinite,  ///< `value` is the index of both tails together, about the median
    };
    Reason reason = Reason::infinite_variance;
    double value = 0;
    double limit = 0;
};

/// Empty where nothing speaks against an interval, and for fewer than 50 values, which may look like anything.
std::optional<TailDoubt> doubt_tails(std::span<const double> values);

/// The same by the tail indices of many samples together, each less its median and over its interquartile range: a
/// method's estimates of many quantities show together what few trials of one do not. Needs 500 values.
class PooledTails {
  public:
    /// A sample whose middle half consists of equal values adds nothing.
    void add(std::span<const double> values);
    [[nodiscard]] std::optional<TailDoubt> doubt() const;

    /// All of them.
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

  private:
    std::vector<double> values_;
};

}  // namespace ff::stats

#pragma once

#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// Why no interval of a mean can be believed. No test is enough alone: tail indices need many values, and the variance
/// of the variance a large one among them.
struct TailDoubt {
    enum class Reason {
        infinite_variance,     ///< `value` is the tail index, significantly below 2
        not_shown_finite,      ///< there are many values, but the index is not shown to be above 2
        few_values_decide,     ///< `value` is the variance of the variance, above `limit`
        outer_tails_infinite,  ///< both tails together, about the median: `value` is their index
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

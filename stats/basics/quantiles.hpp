#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// A copy in ascending order.
std::vector<double> sorted(std::span<const double> values);

/// The `count` largest values, in ascending order, without sorting the others. @pre count <= number of values
std::vector<double> largest(std::span<const double> values, std::size_t count);

/// The middle value, or the mean of the two in the middle, without sorting. @pre values not empty
double median(std::span<const double> values);

/// Quantile of type 7 [hyndman1996] of ascending values. @pre `ascending` is sorted and not empty, 0 <= probability <=
/// 1
double quantile(std::span<const double> ascending, double probability);

/// Several at once, in the order of `probabilities`; sorts a copy. @pre values not empty
std::vector<double> quantiles(std::span<const double> values, std::span<const double> probabilities);

/// Median of |value - reference|; meaningful where the variance is infinite. Empty without values.
std::optional<double> median_absolute_error(std::span<const double> values, double reference);

/// The central range with this `share` of the values, e.g. 0.95: what a single run may give.
struct CentralRange {
    double low = 0;
    double high = 0;
};
std::optional<CentralRange> central_range(std::span<const double> values, double share);

/// Where a value falls among simulated ones.
struct Rank {
    std::size_t below = 0;
    std::size_t equal = 0;
    std::size_t n = 0;
    double percentile = 0;  ///< (below + equal / 2) / n, in [0, 1]
    Interval interval;      ///< Clopper-Pearson, from P(X < value)'s low end to P(X <= value)'s high end
    double p = 0;           ///< two-sided Monte Carlo p-value, at least 2 / (n + 1)
};

/// Empty without values. Values within `tolerance` count as equal (discrete results, printed digits).
std::optional<Rank> rank_among(std::span<const double> values, double value, double level = 0.95, double tolerance = 0);

}  // namespace ff::stats

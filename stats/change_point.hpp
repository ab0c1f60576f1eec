#pragma once

#include "stats/resampling.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Where the level of a series changes most.
struct ChangePoint {
    std::size_t first = 0;  ///< index of the first value after it
    double before = 0;      ///< means
    double after = 0;
    double p = 1;
};

/// Fewest values on each side of a change: a single value is not a level.
inline constexpr std::size_t fewest_on_a_side = 2;

/// The least possible p-value of a series of n values: the share of permutations that keep both sides.
double least_change_p(std::size_t n);

/// The largest difference of means before and after, in standard deviations of the series, compared with that of its
/// permutations: p is exact where all orders are equally likely without a change, whatever the distribution. A slow
/// drift shows as a change in its middle. Empty below four values, and where all are equal.
std::optional<ChangePoint> find_change(std::span<const double> values, const ResamplingPlan& plan);

}  // namespace ff::stats

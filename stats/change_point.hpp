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

/// Values on each side of a change: one value alone is no level.
inline constexpr std::size_t fewest_on_a_side = 2;

/// The least p-value that any series of n values can have: that of the permutations that keep the two sides.
double least_change_p(std::size_t n);

/// The largest difference of means before and after, in the series' own standard deviations, against what permutations
/// of it have: p holds exactly where all orders of the values are equally likely without a change, whatever their
/// distribution. A slow drift shows as a change in its middle. Empty below four values, and where all are equal.
std::optional<ChangePoint> find_change(std::span<const double> values, const ResamplingPlan& plan);

}  // namespace ff::stats

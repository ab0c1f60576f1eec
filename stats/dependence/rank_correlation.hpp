#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

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
/// @pre as many of both  @param level  of the interval
std::optional<RankCorrelation> rank_correlation(std::span<const double> first, std::span<const double> second,
                                                double level);

}  // namespace ff::stats

#pragma once

#include "stats/basics/interval.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/analysis/slopes.hpp"
#include "studies/diagnostics/variance_reduction.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// The group of each value, 0 for the best. A group begins with the best value that differs from the first of the
/// previous group, and contains all following values that do not differ from its own first. Values differ by the
/// intervals of their differences at `level` over all pairs of them together (Bonferroni), which corrects for having
/// picked the best of many.
std::vector<std::size_t> groups_apart(std::span<const stats::Measured> values, double level);

/// The same where `differ` says which of two values (by index) differ.
std::vector<std::size_t> groups_apart(std::span<const double> values,
                                      const std::function<bool(std::size_t, std::size_t)>& differ);

/// One of several slopes, errors or variances, ranked.
struct Ranked {
    std::size_t index = 0;                    ///< into what was ranked
    double value = 0;                         ///< slope, RMSE or factor
    std::optional<stats::Interval> interval;  ///< individual interval; empty for deterministic methods
    std::size_t group = 0;                    ///< see groups_apart
    bool alone = false;                       ///< differs from every other, by the same tests as groups
    /// Interval of its distance from the best, by the same test, in logarithms where these are ranked; empty for the
    /// best and where both are exact.
    std::optional<stats::Interval> behind = {};
};

/// The level of each of several rankings that are to hold together (Bonferroni).
double level_of_each(double level, std::size_t rankings);

/// Slopes on a class of pairs, steepest first: of the RMSE or, where one of them has no variance, of the median error
/// for all. Where no straight line fits, intervals are widened by Slope::misfit. Deterministic methods are left out.
struct RankedSlopes {
    bool of_median = false;
    std::vector<Ranked> slopes;  ///< Ranked::index into the ladders
};
RankedSlopes rank_slopes(std::span<const LadderSlopes> ladders, std::size_t scene, PairClass pair_class, double level);

/// RMSEs of these cells on a class of pairs, smallest first. Cells without a variance, and sampled ones with few
/// trials, are left out; errors at the level of rounding count as equal. Ranked::index is a cell.
std::vector<Ranked> rank_errors(const Analysis& findings, std::span<const std::size_t> cells, PairClass pair_class,
                                double level);

/// RMSE² N of these cells, 1 / efficiency, the same way.
std::vector<Ranked> rank_efforts(const Analysis& findings, std::span<const std::size_t> cells, PairClass pair_class);

/// Variances of all cells that are compared with this random one, smallest first, including the random one itself with
/// a factor of 1. Ranked::index is a cell.
std::vector<Ranked> rank_reductions(const Analysis& findings, std::span<const VarianceReduction> reductions,
                                    std::size_t random_cell, PairClass pair_class, double level);

}  // namespace ff::studies

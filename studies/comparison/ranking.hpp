#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/analysis/slopes.hpp"
#include "studies/claims/comparison.hpp"
#include "studies/diagnostics/variances.hpp"

#include <cstddef>
#include <functional>
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

/// The same for rankings of which a study has one for each class of pairs of each scene.
double level_of_each_class(const Analysis& findings);

/// Slopes on a class of pairs, steepest first: of the RMSE or, where one of them has no variance, of the median error
/// for all. Where a straight line may not fit, intervals are widened by Slope::misfit. Deterministic methods are left
/// out.
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

/// Two methods compared by their RMSE on a class of pairs.
struct Rivalry {
    std::size_t scene = 0;
    PairClass pair_class = PairClass::other;
    std::size_t better = 0;                 ///< index into Analysis::cells
    std::optional<std::size_t> worse = {};  ///< empty where the study has one method only
    std::optional<double> ratio = {};       ///< RMSE of the worse / RMSE of the better; empty where that is rounding
    /// Interval of the ratio, at the study's level over all pairs of methods from which these two are picked, and over
    /// all rivalries of the study (Bonferroni); empty where neither varies, where it is doubtful, and where an end
    /// would be infinite.
    std::optional<stats::Interval> interval = {};
    bool apart = false;     ///< the interval lies above 1, or neither varies and the errors differ
    bool doubtful = false;  ///< one varies without an interval: its variance is infinite, or its trials are few

    /// Whether the interval decides which is better; where nothing varies, the errors themselves decide.
    [[nodiscard]] bool decided() const;
};

/// The cells of a scene whose methods are compared, one each, at sizes that allow the comparison. With published
/// tables, the methods and sizes of the last table that compares two methods; otherwise the cells of the size that most
/// methods share (the largest of several), without closed forms and without point sets that are neither randomised nor
/// quadratures.
std::vector<std::size_t> compared_cells(const Analysis& findings, std::size_t scene,
                                        const std::vector<TableComparison>& published);

/// Whether a point set is neither randomised nor a quadrature: its error is that of a single set, has no interval, and
/// may be luck.
bool may_be_luck(const StudyPlan& plan, const Cell& cell);

/// The two best of these cells on each class of pairs of each scene.
std::vector<Rivalry> find_rivals(const Analysis& findings, const std::vector<TableComparison>& published);

}  // namespace ff::studies

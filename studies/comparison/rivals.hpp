#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/claims/comparison.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies {

/// Two methods compared by their RMSE on a class of pairs.
struct Rivalry {
    std::size_t scene = 0;
    PairClass pair_class = PairClass::other;
    std::size_t better = 0;            ///< index into Analysis::cells
    std::optional<std::size_t> worse;  ///< empty where the study has one method only
    std::optional<double> ratio;       ///< RMSE of the worse / RMSE of the better; empty where that is rounding
    /// Interval of the ratio, at the study's level over all pairs of methods from which these two are picked, and over
    /// all rivalries of the study (Bonferroni); empty where neither varies, where it is doubtful, and where an end
    /// would be infinite.
    std::optional<stats::Interval> interval;
    bool apart = false;     ///< the interval lies above 1, or neither varies and the errors differ
    bool doubtful = false;  ///< one varies without an interval: its variance is infinite, or its trials are few

    /// Whether the interval decides which is better; where nothing varies, the errors themselves decide.
    [[nodiscard]] bool decided() const;
};

/// Errors of form factors below this are rounding.
inline constexpr double rounding_error = 1e-12;

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

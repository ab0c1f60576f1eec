#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/interval.hpp"
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
    std::size_t better = 0;            ///< index into Findings::cells
    std::optional<std::size_t> worse;  ///< empty where the study has one method only
    std::optional<double> ratio;       ///< RMSE of the worse / RMSE of the better; empty where that is rounding
    /// Of the ratio, at the study's level over all pairs of methods that the two are the best of (Bonferroni); empty
    /// where neither varies, and where it is doubtful.
    std::optional<stats::Interval> interval;
    bool doubtful = false;  ///< one varies without an interval: its variance is infinite, or its trials are few

    /// The interval leaves no doubt which is the better one; where nothing varies, the errors themselves.
    [[nodiscard]] bool decided() const;
};

/// Errors of form factors below this are rounding.
inline constexpr double rounding_error = 1e-12;

/// The cells of a scene whose methods are compared, one each, at sizes that allow the comparison. Where tables of a
/// publication are at hand, the methods and sizes of the last table that sets two methods side by side; otherwise the
/// cells of the size that most methods share (the largest of several). Closed forms are left out there, and point sets
/// that are neither randomised nor quadratures.
std::vector<std::size_t> compared_cells(const Findings& findings, std::size_t scene,
                                        const std::vector<TableComparison>& published);

/// The two best of these cells on each class of pairs of each scene.
std::vector<Rivalry> find_rivals(const Findings& findings, const std::vector<TableComparison>& published);

}  // namespace ff::studies

#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// A pair of faces whose trials seem to have infinite variance, although theory says otherwise or is silent.
struct HeavyTail {
    std::size_t cell = 0;
    Quantity pair;
    double index = 0;  ///< tail index of the upper tail; the variance is infinite below 2
};

/// Tests the tail of every pair that is treated as having a variance (stats/variances/tails.hpp), at the study's
/// error rate over all of them together. Cells with fewer than 200 trials are skipped: a tail does not show in fewer.
std::vector<HeavyTail> find_heavy_tails(const CellReader& cells, const Analysis& findings);

/// The sample standard deviation of one quantity beside the exact one.
struct VarianceComparison {
    Quantity quantity;
    double exact = 0;  ///< computed from the exact patch-to-face factors (studies/theory/sr_distribution.hpp)
    double sampled = 0;
    double p = 0;  ///< two-sided chi-squared test of equality
};

/// Cross-check of one cell whose exact variance is known: independent rays, nothing in between.
struct VarianceCheck {
    std::size_t cell = 0;
    std::vector<VarianceComparison> quantities;  ///< distinct pairs and row sums that vary
    double adjusted_p = 1;                       ///< smallest p-value, adjusted for quantities (Holm) and cells (Sidak)
    double smallest_ratio = 1;                   ///< smallest sampled / exact
    double largest_ratio = 1;
};

/// Every cell whose exact variance is known and that has two trials. One error rate for all of them together: if every
/// spread is right, the chance that any `adjusted_p` is below alpha is at most alpha.
std::vector<VarianceCheck> check_variances(const Analysis& findings);

/// The factor by which a cell's variance is smaller than with as many independent random points, on all pairs of a
/// class together.
struct VarianceReduction {
    std::size_t cell = 0;
    std::size_t random_cell = 0;  ///< the cell with sampler "random" and the same scene, estimator, completion and size
    PairClass pair_class = PairClass::other;
    double factor = 1;
    stats::Interval interval;
};

/// One for each cell and class that has a variance with an interval, and a random counterpart, in the order of cells.
/// Pure.
std::vector<VarianceReduction> compare_with_random(const Analysis& findings);

}  // namespace ff::studies

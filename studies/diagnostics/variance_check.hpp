#pragma once

#include "studies/analysis/analysis.hpp"

#include <vector>

namespace ff::studies {

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

}  // namespace ff::studies

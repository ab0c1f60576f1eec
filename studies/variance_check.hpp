#pragma once

#include "studies/analysis.hpp"

#include <optional>
#include <vector>

namespace ff::studies {

/// One quantity's standard deviation as sampled by the trials, beside the exact one.
struct VarianceComparison {
    Quantity quantity;
    double exact = 0;  ///< from the exact patch-to-face factors (studies/sr_distribution.hpp)
    double sampled = 0;
    double p = 0;  ///< two-sided chi-squared test of equality
};

/// Cross-check of one cell whose exact variance is known: independent rays, nothing in between.
struct VarianceCheck {
    std::size_t cell = 0;
    std::vector<VarianceComparison> quantities;  ///< distinct pairs and row sums that vary
    double adjusted_p = 1;                       ///< smallest Holm-adjusted p-value
    double smallest_ratio = 1;                   ///< of sampled / exact
    double largest_ratio = 1;
};

/// Empty for cells whose exact variance is not known, and below two trials.
std::optional<VarianceCheck> check_variance(const Findings& findings, std::size_t cell);

}  // namespace ff::studies

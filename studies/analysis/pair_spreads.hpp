#pragma once

#include "stats/means/mean_test.hpp"
#include "studies/analysis/analysis.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// The variances of the trials of a cell's pairs, by the rule for means applied to squared deviations.
struct PairSpreads {
    /// ln(variance) of each pair; empty where there is no finite variance, where trials are few, and where they, or
    /// their squared deviations, do not vary.
    std::vector<std::optional<stats::Measured>> logarithms;
    double skewness = 0;  ///< median over pairs, of the mean squared deviation
};
PairSpreads spreads_of(std::vector<std::optional<stats::Measured>> logarithms);
PairSpreads spreads_of(const StudyPlan& plan, const CellAnalysis& found, const CellEstimates& estimates,
                       std::span<const Quantity> pairs);

/// The two logarithms of a pair, ready for comparison: the trials of the smaller variance may have missed a long tail,
/// so that it is taken to be at least as skewed as those of the cell's other pairs. Empty where either is empty.
std::optional<std::array<stats::Measured, 2>> compared_spreads(const PairSpreads& first, const PairSpreads& second,
                                                               std::size_t pair);

/// The ratio of standard deviations, at least 1, that a test at `level` detects with this power where trials are spread
/// and skewed like these; approximate, and infinite where it would detect none.
double detectable_ratio(const std::array<stats::Measured, 2>& spreads, double level, double power);

}  // namespace ff::studies

#pragma once

#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <cstddef>

namespace ff::reports {

/// A row for each method and size: trials, RMSE by class with its interval, sum of relative errors, bias, equivalence.
Table methods_table(const studies::StudyResults& results);

/// A row for each ladder and class of pairs: slopes with intervals, the rate that theory expects, the verdict.
Table slopes_table(const studies::StudyResults& results);

/// The same with both intervals of each slope, lack of fit, and what the theory rests on.
Table convergence_table(const studies::StudyResults& results);

/// Pairs of faces of the catalogue: estimate, interval, exact value, deviation.
Table configurations_table(const studies::StudyResults& results);

/// Scenes of families by the share that is hidden: exact value, and every method's error and slope on the pair.
Table occlusion_table(const studies::StudyResults& results);

/// How the closure error of deterministic methods falls with subdivision, ours and as printed.
Table error_law_table(const studies::StudyResults& results);

/// Measures of evenness of the points beside the errors that they make.
Table evenness_table(const studies::StudyResults& results);

/// Variances against those of random points.
Table reductions_table(const studies::StudyResults& results);

/// How often intervals contain the exact value.
Table coverage_table(const studies::StudyResults& results);

/// Sampled standard deviations against exact ones.
Table spreads_table(const studies::StudyResults& results);

/// A published table: each figure as printed, ours, and where the printed one falls.
Table published_table(const studies::PublishedResults& published, std::size_t index, double alpha);

/// The publication's claims with verdict and evidence.
Table claims_table(const studies::PublishedResults& published);

/// Every distinct pair and row sum of one cell: exact value, mean, bias with interval, spread.
Table pairs_table(const studies::StudyResults& results, std::size_t cell);

}  // namespace ff::reports

#pragma once

#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <vector>

namespace ff::reports {

/// A row for each method and size: trials, RMSE by class with its interval, sum of relative errors, bias, equivalence.
Table methods_table(const studies::StudyResults& results);

/// A row for each ladder and class of pairs: slopes with intervals, the rate that theory expects, the verdict.
Table slopes_table(const studies::StudyResults& results);

/// The steepest slopes of each kind of pairs, as the answer ranks them.
Table rates_table(const studies::StudyResults& results);

/// The same with both intervals of each slope, lack of fit, and the basis of the theory.
Table convergence_table(const studies::StudyResults& results);

/// Pairs of faces of the catalogue: estimate, interval, exact value, deviation.
Table configurations_table(const studies::StudyResults& results);

/// The same by method: how many estimates agree with exact values, and the one furthest off.
Table agreement_table(const studies::StudyResults& results);

/// Scenes of families by the occluded fraction: exact value, and every method's error and slope on the pair.
Table occlusion_table(const studies::StudyResults& results);

/// How the closure error of deterministic methods falls with subdivision, ours and as printed.
Table error_law_table(const studies::StudyResults& results);

/// Measures of the points' evenness beside their errors.
Table evenness_table(const studies::StudyResults& results);

/// Variances relative to those of random points.
Table reductions_table(const studies::StudyResults& results);

/// How often intervals contain the exact value.
Table coverage_table(const studies::StudyResults& results);

/// The least coverage of each rule with each number of replicates.
Table least_coverage_table(const studies::StudyResults& results);

/// All methods against each other, at equal evaluations, processor time and error: for a study with one scene, each
/// class of pairs and method; for others, the best of each scene.
/// @param timed  the comparison by measured time, which differs from run to run
Table contests_table(const studies::StudyResults& results, bool timed);

/// The best method on each kind of pairs, and in how many scenes, for studies with several scenes.
Table decisions_table(const studies::StudyResults& results, bool timed);

/// The same for several amounts of processor time, which differ from run to run.
Table timed_decisions_table(const studies::StudyResults& results);

/// Which claims are shown: only those stated by methods or studies, or also the errors that a single run would suggest.
enum class Claims { stated, all };

/// How often errors are within the claimed ones.
Table claimed_errors_table(const studies::StudyResults& results, Claims claims);

/// Sampled standard deviations against exact ones.
Table spreads_table(const studies::StudyResults& results);

/// A published table: each figure as printed, ours, and the position of the printed one among ours.
Table published_table(const studies::PublishedResults& published, std::size_t index, double alpha);

/// The publication's claims with verdict and evidence.
Table claims_table(const studies::PublishedResults& published);

/// Every distinct pair and row sum of one cell: exact value, mean, bias with interval, spread.
Table pairs_table(const studies::StudyResults& results, std::size_t cell);

/// The rows of the exitance that the answer tells: the compared methods at the reflectance of the headline, with every
/// treatment. Empty where the study has no [radiosity].
Table told_light_table(const studies::StudyResults& results);

/// Matrices, exitance, solvers and the order of the bias; empty where the study has no [radiosity].
std::vector<Table> radiosity_tables(const studies::StudyResults& results);

}  // namespace ff::reports

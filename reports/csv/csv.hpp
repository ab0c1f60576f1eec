#pragma once

#include "reports/json/json_records.hpp"
#include "studies/results/results.hpp"
#include "studies/store/store.hpp"

#include <ostream>

namespace ff::reports {

/// One row per scene, method, size and quantity; a column is empty where a value does not exist (docs/results.md).
void write_summary_csv(std::ostream& out, const studies::Analysis& findings);

/// One row per ladder, class or pair, and size of the error: how fast it falls.
void write_slopes_csv(std::ostream& out, const studies::StudyResults& results);

/// One row per cell, class, kind of interval and number of replicates: how often it contains the exact value.
void write_coverage_csv(std::ostream& out, const studies::StudyResults& results);

/// One row per pair of methods at a budget: how many times worse one is.
void write_comparisons_csv(std::ostream& out, const studies::StudyResults& results, Timed timed);

/// One row per cell, class and claim: how often the claim holds.
void write_claimed_errors_csv(std::ostream& out, const studies::StudyResults& results);

/// The direct estimate of every pair in every trial, before completion.
void write_trials_csv(std::ostream& out, const studies::Store& store);

/// Tables of a study with [radiosity]; docs/results.md has their columns. @pre results.radiosity
/// One row per cell and treatment: defects of the matrices, and the reflectances up to which they serve.
void write_matrices_csv(std::ostream& out, const studies::StudyResults& results);
/// One row per cell, treatment and setting: what decides whether the system can be solved.
void write_systems_csv(std::ostream& out, const studies::StudyResults& results);
/// One row per cell, treatment, setting and face: the exitance.
void write_exitance_csv(std::ostream& out, const studies::StudyResults& results);
/// One row per cell or exact system, setting and solver: iterations and flops.
void write_solvers_csv(std::ostream& out, const studies::StudyResults& results);
/// The residual of the first trial after some iterations of each solver.
void write_residuals_csv(std::ostream& out, const studies::StudyResults& results);

}  // namespace ff::reports

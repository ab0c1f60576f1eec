#pragma once

#include "studies/results/results.hpp"

#include <ostream>

namespace ff::reports {

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

#pragma once

#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <vector>

namespace ff::reports {

/// Matrices, exitance, solvers and the order of the bias; empty where the study has no [radiosity].
std::vector<Table> radiosity_tables(const studies::StudyResults& results);

}  // namespace ff::reports

#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A line about the apparent errors of single runs if dependent rays are treated as independent; empty where all are
/// independent.
std::vector<std::string> one_run_errors_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

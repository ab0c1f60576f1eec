#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// Findings of a study beyond the errors of its methods, a sentence each: heavy tails, slopes, variances, coverage,
/// stopping rules, error laws.
std::vector<std::string> results_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

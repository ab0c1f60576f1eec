#pragma once

#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// Version of results.json, as in "ffstudy.results/1"; docs/results.md describes it.
inline constexpr int results_json_version = 1;

/// Summaries, verdicts, comparisons and claims; raw trials are in trials.csv and the store. `null` where a value does
/// not exist.
std::string results_json(const studies::StudyResults& results);

}  // namespace ff::reports

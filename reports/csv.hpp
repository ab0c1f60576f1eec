#pragma once

#include "studies/analysis.hpp"
#include "studies/store.hpp"

#include <ostream>

namespace ff::reports {

/// One row per scene, method, size and quantity; a column is empty where a value does not exist (docs/results.md).
void write_summary_csv(std::ostream& out, const studies::Findings& findings);

/// The direct estimate of every pair in every trial, before completion.
void write_trials_csv(std::ostream& out, const studies::Store& store);

}  // namespace ff::reports

#pragma once

#include "reports/text/text_table.hpp"
#include "studies/gates/gate_plan.hpp"
#include "studies/plan/plan.hpp"
#include "studies/results/results.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <span>
#include <string>

namespace ff::reports {

/// The result in a dozen lines: a row for each method and size, then the verdict on the publication.
std::string terminal_summary(const studies::StudyResults& results, const TextStyle& style = {});

/// A run's work in advance: units, trials, evaluations and expected time.
std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads, const TextStyle& style = {});

/// Trials and time of each gate, and in total; for gates on a file of estimates, trials needed and available.
std::string gates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files,
                       std::span<const studies::gates::Plan> plans, unsigned threads);

}  // namespace ff::reports

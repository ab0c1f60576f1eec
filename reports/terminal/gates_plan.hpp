#pragma once

#include "studies/gates/gate_plan.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <span>
#include <string>

namespace ff::reports {

/// Trials and time of each gate, and in total; for gates on a file of estimates, trials needed and available.
std::string gates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files,
                       std::span<const studies::gates::Plan> plans, unsigned threads);

}  // namespace ff::reports

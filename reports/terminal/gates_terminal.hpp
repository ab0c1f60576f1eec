#pragma once

#include "reports/text/colour.hpp"
#include "studies/gates/check_results.hpp"
#include "studies/gates/estimate_gates.hpp"
#include "studies/gates/gate_plan.hpp"
#include "studies/gates/seed_sweep.hpp"

#include <span>
#include <string>

namespace ff::reports {

/// What is checked, at which risks.
std::string gates_heading(const studies::GatesSpec& spec);

/// One line: verdict, gate, and the comparison that decided; another with a picture where there are many bins.
std::string gate_line(const studies::GateResult& result, Colour colour);

/// The same without verdict and name: for messages elsewhere.
std::string gate_in_words(const studies::GateResult& result);

/// How many passed, failed and are undecided.
std::string gates_summary(const studies::CheckResults& check);

/// Trials and time of each gate, and of all; of gates on a file of estimates, trials that are needed and there.
std::string gates_plan(const studies::GatesSpec& spec, std::span<const studies::EstimatesPlan> files,
                       std::span<const studies::GatePlan> plans, unsigned threads);

/// Failure rates over many seeds.
std::string seed_sweep_table(const studies::GatesSpec& spec, std::span<const studies::SeedSweep> sweeps);

}  // namespace ff::reports

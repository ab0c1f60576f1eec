#pragma once

#include "reports/text/text_table.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::reports {

/// Says what is checked, and with which risks.
std::string gates_heading(const studies::gates::Spec& spec);

/// One line: verdict, gate, and the deciding comparison; another one with a picture where there are many bins.
std::string gate_line(const studies::gates::GateResult& result, Colour colour);

/// The same without verdict and name, for messages elsewhere.
std::string gate_in_words(const studies::gates::GateResult& result);

/// "band ±0.01", "band 0.5 or more"
std::string band_in_words(const studies::gates::Band& band);

/// How many gates passed, failed and are undecided.
std::string gates_summary(const studies::gates::CheckResults& check);

/// Trials needed and trials available, for gates on a file of estimates.
std::string estimates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files);

/// Characters of the longest name of a gate, for the first column of tables.
std::size_t name_width(const studies::gates::Spec& spec);

/// Failure rates over many seeds.
std::string seed_sweep_table(const studies::gates::Spec& spec, std::span<const studies::gates::SeedSweep> sweeps);

}  // namespace ff::reports

#pragma once

#include "studies/gates/gate_plan.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <optional>
#include <span>
#include <vector>

namespace ff::studies::gates {

/// Judges every effect of a gate on the trials so far. Pure.
/// @param estimates  of the plan's cells, in their order
std::vector<Comparison> compare(const Gate& gate, const Plan& plan, std::span<const CellEstimates> estimates);

/// Runs a gate whose trials are planned, look by look until it is decided, at most as often as the file says.
/// The result depends on the file and the seed alone.
/// @return empty where it was stopped
std::optional<GateResult> run_gate(const Spec& spec, const Plan& plan, const GateRunOptions& options);

/// Runs one look of a gate and keeps its numbers for later comparisons.
/// @pre the plan was prepared to save a baseline
std::optional<StoredGate> run_to_store(const Spec& spec, const Plan& plan, const GateRunOptions& options);

}  // namespace ff::studies::gates

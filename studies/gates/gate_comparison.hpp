#pragma once

#include "studies/gates/gate_plan.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <span>
#include <vector>

namespace ff::studies::gates {

/// Every effect of a gate judged on the trials so far. Pure.
/// @param estimates  of the plan's cells, in their order
std::vector<Comparison> compare(const Gate& gate, const Plan& plan, std::span<const CellEstimates> estimates);

}  // namespace ff::studies::gates

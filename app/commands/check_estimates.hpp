#pragma once

#include "app/command_line/options.hpp"
#include "studies/gates/estimate_gates.hpp"
#include "studies/gates/gate.hpp"

#include <vector>

namespace ff::app {

/// Gates on the file of --estimates, be it of trials or of means with their errors; none where there is no file.
/// @throws UserError, IoError
std::vector<studies::GateResult> judge_file(const CheckCommand& command, const studies::GatesSpec& spec);

/// Trials that each gate on a file of trials needs.
std::vector<studies::EstimatesPlan> plan_file(const CheckCommand& command, const studies::GatesSpec& spec);

}  // namespace ff::app

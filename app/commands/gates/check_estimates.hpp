#pragma once

#include "app/command_line/check_options.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <vector>

namespace ff::app {

/// @throws UserError where the bands file and the files of estimates do not go together
void expect_estimates(const CheckCommand& command, const studies::gates::Spec& spec);

/// Gates on the file of --estimates, be it of trials or of means with their errors; none where there is no file.
/// @throws UserError, IoError
std::vector<studies::gates::GateResult> judge_file(const CheckCommand& command, const studies::gates::Spec& spec);

/// Trials that each gate on a file of trials needs.
std::vector<studies::gates::EstimatesPlan> plan_file(const CheckCommand& command, const studies::gates::Spec& spec);

}  // namespace ff::app

#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported_file.hpp"

namespace ff::studies {

/// Runs of a bin from which their own spread is the error of their mean; fewer rest on the errors that they state.
inline constexpr std::size_t enough_runs = 10;

/// Runs from which the errors that they state can be judged.
inline constexpr std::size_t fewest_runs = 5;

/// A gate on what another program reports.
/// @param against  a second such file, null where none is given
/// @throws UserError where nothing, or nothing that belongs together, would be compared: a missing column or file,
///   bins that only one file has, runs and files that hold the same numbers
GateResult judge_reported(const GatesSpec& spec, const Gate& gate, const ReportedFile& file,
                          const ReportedFile* against);

}  // namespace ff::studies

#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

namespace ff::studies::gates {

/// From this many runs of a bin on, their spread gives the error of their mean; fewer rely on stated errors.
inline constexpr std::size_t enough_runs = 10;

/// Fewest runs from which stated errors can be judged.
inline constexpr std::size_t fewest_runs = 5;

/// Judges a gate on another program's report.
/// @param against  a second such file, null where none is given
/// @throws UserError where there is nothing comparable: a missing column or file, bins that only one file has, runs or
///   files that hold the same numbers
GateResult judge_reported(const Spec& spec, const Gate& gate, const ReportedFile& file, const ReportedFile* against);

/// How many runs like those of the file it would take for every bin of a gate on means or shares to pass.
/// @throws as judge_reported; UserError for other kinds, and where no number of runs can decide
EstimatesPlan plan_reported(const Spec& spec, const Gate& gate, const ReportedFile& file, const ReportedFile* against);

}  // namespace ff::studies::gates

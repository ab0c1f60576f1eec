#pragma once

#include "app/command_line/options.hpp"
#include "app/process/exit_code.hpp"

#include <string>

namespace ff::app {

/// Runs a study, or resumes it, writes its reports, prints a short result.
ExitCode run(const RunCommand& command);

/// Light in an enclosure that sees itself, by exact factors and by rays drawn from them.
ExitCode enclosure(const EnclosureCommand& command);

/// All form factors between the faces of a scene, each with an interval; inconclusive where one misses the tolerance.
ExitCode form_factors(const FormFactorsCommand& command);

/// Flows of heat or light between the faces of a scene; inconclusive where one is not within the tolerance.
ExitCode heat(const HeatCommand& command);

/// Writes reports from a store.
ExitCode report(const ReportCommand& command);

/// Brings the stores of shards together and writes the reports; inconclusive where units are missing.
ExitCode merge(const MergeCommand& command);

/// Two runs side by side; failed where some method differs, else inconclusive where one cannot be tested.
ExitCode compare(const CompareCommand& command);

/// Checks published tables for contradictions; failed where there are some.
ExitCode audit(const AuditCommand& command);

/// Checks the gates of a bands file: failed where one fails, else inconclusive where one is undecided.
ExitCode check(const CheckCommand& command, const OutsideOptions& outside);

/// Measures what gates and intervals promise; failed where a claim does not hold.
ExitCode gates_selftest(const SelftestCommand& command);

/// Measures how often the intervals of form_factors hold exact values; failed where too seldom.
ExitCode form_factors_selftest(const SelftestCommand& command);

/// Lists samplers, estimators, scenes, studies or formats; without a kind, what there is of each.
ExitCode list(const ListCommand& command);

/// Prints what a sampler, estimator, scene or study is, its source and its limits.
ExitCode explain(const ListCommand& command);

}  // namespace ff::app

#pragma once

#include "app/command_line/options.hpp"
#include "app/process/exit_code.hpp"

#include <string>

namespace ff::app {

/// Runs or resumes a study, writes its reports, prints a short result.
ExitCode run(const RunCommand& command);

/// Light in an enclosure with self-views, by exact factors and by rays drawn from them.
ExitCode enclosure(const EnclosureCommand& command);

/// All form factors between the faces of a scene, with intervals; inconclusive where one misses the tolerance.
ExitCode form_factors(const FormFactorsCommand& command);

/// Writes a scene in another format.
ExitCode convert(const ConvertCommand& command);

/// Flows of heat or light between the faces of a scene; inconclusive where one is not within the tolerance.
ExitCode heat(const HeatCommand& command);

/// Writes reports from a store.
ExitCode report(const ReportCommand& command);

/// Merges the stores of shards and writes the reports; inconclusive where units are missing.
ExitCode merge(const MergeCommand& command);

/// Compares two runs; failed where some method differs, else inconclusive where one cannot be tested.
ExitCode compare(const CompareCommand& command);

/// Checks published tables for contradictions; failed where there are some.
ExitCode audit(const AuditCommand& command);

/// Checks the gates of a bands file: failed where one fails, else inconclusive where one is undecided.
ExitCode check(const CheckCommand& command, const OutsideOptions& outside);

/// Lists samplers, estimators, scenes, studies or formats; without a kind, an overview.
ExitCode list(const ListCommand& command);

/// Describes a sampler, estimator, scene or study, with source and limits.
ExitCode explain(const ListCommand& command);

}  // namespace ff::app

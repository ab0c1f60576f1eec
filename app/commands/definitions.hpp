#pragma once

#include "app/command_line/options.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/gate_commands.hpp"
#include "app/commands/hidden_commands.hpp"
#include "app/commands/point_commands.hpp"

namespace ff::app {

/// Each adds a command with its options, which fill `command`; parsing one sets `action`.
void add_report(CLI::App& app, ReportCommand& command, Action& action);
void add_compare(CLI::App& app, CompareCommand& command, Action& action);
void add_merge(CLI::App& app, MergeCommand& command, Action& action);
void add_audit(CLI::App& app, AuditCommand& command, Action& action);
void add_check(CLI::App& app, CheckCommand& command, OutsideOptions& outside, Action& action);
void add_selftest(CLI::App& app, SelftestCommand& command, Action& action);
void add_form_factors_selftest(CLI::App& app, SelftestCommand& command, Action& action);
void add_heat_selftest(CLI::App& app, SelftestCommand& command, Action& action);
void add_list(CLI::App& app, ListCommand& command, Action& action);
void add_explain(CLI::App& app, ListCommand& command, Action& action);
void add_points(CLI::App& app, PointsCommand& command, Action& action);
void add_check_sampler(CLI::App& app, CheckSamplerCommand& command, Action& action);

}  // namespace ff::app

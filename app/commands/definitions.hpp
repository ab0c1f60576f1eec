#pragma once

#include "app/command_line/options.hpp"
#include "app/commands/hidden_commands.hpp"
#include "app/commands/point_commands.hpp"

#include <string>

namespace ff::app {

/// The groups of commands in --help.
inline constexpr const char* everyday = "Everyday";
inline constexpr const char* laboratory = "Laboratory";
inline constexpr const char* checks = "Checks";
inline constexpr const char* built_in = "Built-in studies";

CLI::App* add_command(CLI::App& app, const char* group, std::string name, std::string summary);

/// Each adds a command with its options, which fill `command`; parsing one sets `action`.
void add_report(CLI::App& app, ReportCommand& command, Action& action);
void add_compare(CLI::App& app, CompareCommand& command, Action& action);
void add_merge(CLI::App& app, MergeCommand& command, Action& action);
void add_audit(CLI::App& app, AuditCommand& command, Action& action);
void add_selftest(CLI::App& app, SelftestCommand& command, Action& action);
void add_form_factors_selftest(CLI::App& app, SelftestCommand& command, Action& action);
void add_list(CLI::App& app, ListCommand& command, Action& action);
void add_explain(CLI::App& app, ListCommand& command, Action& action);
void add_points(CLI::App& app, PointsCommand& command, Action& action);
void add_check_sampler(CLI::App& app, CheckSamplerCommand& command, Action& action);
void add_help(CLI::App& app, std::string& name, Action& action);

}  // namespace ff::app

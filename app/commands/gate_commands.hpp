#pragma once

#include "app/command_line/action.hpp"
#include "app/command_line/check_options.hpp"

#include <CLI/CLI.hpp>

namespace ff::app {

/// Commands that judge what other programs report and run nothing themselves: the commands of the smaller program.

/// `ffstudy check` with the options for gates on files; the caller sets its action.
CLI::App* add_check_of_files(CLI::App& app, CheckCommand& command);

/// `ffstudy trend`
void add_trend(CLI::App& app, TrendCommand& command, Action& action);

/// Judges a bands file with gates on files only.
ExitCode check_files(const CheckCommand& command);

}  // namespace ff::app

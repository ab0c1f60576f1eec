#pragma once

#include "app/command_line/action.hpp"
#include "app/command_line/check_options.hpp"

#include <CLI/CLI.hpp>

namespace ff::app {

/// Commands that judge what other programs report, and run nothing of their own: what the smaller program has.

/// `ffstudy check` with the options that gates on files have; the caller says what it does.
CLI::App* add_check_of_files(CLI::App& app, CheckCommand& command);

/// `ffstudy trend`
void add_trend(CLI::App& app, TrendCommand& command, Action& action);

/// Judges a bands file that has gates on files alone.
ExitCode check_files(const CheckCommand& command);

}  // namespace ff::app

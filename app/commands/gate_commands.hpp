#pragma once

#include "app/command_line/check_options.hpp"
#include "app/command_line/command_definition.hpp"
#include "app/process/exit_code.hpp"

namespace ff::app {

/// Commands that judge what other programs report and run nothing themselves: the commands of the smaller program.

/// `ffstudy check` with the options for gates on files; the caller sets its action.
CommandDefinition& add_check_of_files(ProgramDefinition& program, CheckCommand& command);

/// `ffstudy trend`
void add_trend(ProgramDefinition& program, TrendCommand& command);

/// Judges a bands file with gates on files only.
ExitCode check_files(const CheckCommand& command);

}  // namespace ff::app

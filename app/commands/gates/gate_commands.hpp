#pragma once

#include "app/command_line/check_options.hpp"
#include "app/command_line/command_definition.hpp"
#include "app/process/exit_code.hpp"

namespace ff::app {

/// `ffstudy check` with the options for gates on what other programs report, which the smaller program has too; the
/// caller sets its action.
CommandDefinition& add_check_of_files(ProgramDefinition& program, CheckCommand& command);

/// Judges a bands file with gates on files only.
ExitCode check_files(const CheckCommand& command);

}  // namespace ff::app

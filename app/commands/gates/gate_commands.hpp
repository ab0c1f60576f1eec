#pragma once

#include "app/command_line/check_options.hpp"
#include "app/command_line/command_definition.hpp"

namespace ff::app {

inline constexpr const char* check_summary = "Check the gates of a bands file: pass, fail or inconclusive";

/// Options of `ffstudy check` for gates on what other programs report.
void add_options_of_files(CommandDefinition& sub, CheckCommand& command);

/// `ffstudy check` of the smaller program, which has these gates only.
void add_check_of_files(ProgramDefinition& program);

/// Writes the contents of --estimates as a file of means for --against (--save-baseline).
/// @throws UserError, IoError
void save_means(const CheckCommand& command);

}  // namespace ff::app

#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/completion.hpp"

namespace ff::app {

/// Commands used by the build and by shells, hidden from help: `complete` and `man_pages`.
/// @param names  for `complete`
void add_hidden_commands(ProgramDefinition& program, const NamesOfType& names);

}  // namespace ff::app

#pragma once

#include "app/command_line/action.hpp"
#include "app/command_line/completion.hpp"

#include <CLI/CLI.hpp>

namespace ff::app {

/// Commands used by the build and by shells, hidden from help: `complete` and `man_pages`.
/// @param names  for `complete`
void add_hidden_commands(CLI::App& app, const NamesOfType& names, Action& action);

}  // namespace ff::app

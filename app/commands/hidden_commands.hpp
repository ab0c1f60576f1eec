#pragma once

#include "app/process/exit_code.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace ff::app {

/// What main does once the command line is understood.
using Action = std::function<ExitCode()>;

/// Commands that the build and the shells give, hidden from help: `complete` and `man_pages`.
void add_hidden_commands(CLI::App& app, Action& action);

}  // namespace ff::app

#pragma once

#include "app/process/exit_code.hpp"

#include <functional>
#include <span>

namespace ff::app {

/// Runs an action, and turns any exception into a message with the input that caused it, and a documented exit code.
/// Exceptions that nobody can catch, from a destructor or a library's thread, are reported too and end the process.
/// @param arguments  of the program, its name first; they live as long as it does
ExitCode guarded(std::span<char* const> arguments, const std::function<ExitCode()>& act);

}  // namespace ff::app

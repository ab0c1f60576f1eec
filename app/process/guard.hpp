#pragma once

#include "app/process/exit_code.hpp"

#include <functional>
#include <span>

namespace ff::app {

/// Acts, and turns whatever is thrown into a message with the input that it came from, and a documented exit code.
/// What no caller can catch, of a destructor or of a thread of a library, is told in the same way and ends the process.
/// @param arguments  of the program, its name first; they live as long as it does
ExitCode guarded(std::span<char* const> arguments, const std::function<ExitCode()>& act);

}  // namespace ff::app

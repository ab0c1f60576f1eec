#pragma once

#include "app/process/exit_code.hpp"

#include <functional>

namespace ff::app {

/// What main does once the command line is understood.
using Action = std::function<ExitCode()>;

}  // namespace ff::app

#pragma once

#include "app/command_line/options.hpp"
#include "app/process/exit_code.hpp"

namespace ff::app {

/// Form factors from the points of --from to the faces of a scene.
ExitCode sensor_factors(const FormFactorsCommand& command);

}  // namespace ff::app

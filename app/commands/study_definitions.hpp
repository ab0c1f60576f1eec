#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/options.hpp"

namespace ff::app {

// The commands that run a study. Each function adds one with its options, which fill in `command`.

void add_run(ProgramDefinition& program, RunCommand& command);
void add_built_in_studies(ProgramDefinition& program, RunCommand& command);
void add_convergence(ProgramDefinition& program, studies::ConvergenceRequest& request, RunCommand& command);
void add_radiosity(ProgramDefinition& program, RadiosityOptions& options, RunCommand& command);

}  // namespace ff::app

#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/options.hpp"

namespace ff::app {

// The commands on form factors of a scene. Each function adds one with its options, which fill in `command`.

void add_form_factors(ProgramDefinition& program, FormFactorsCommand& command);
void add_convert(ProgramDefinition& program, ConvertCommand& command);
void add_heat(ProgramDefinition& program, HeatCommand& command);
void add_enclosure(ProgramDefinition& program, EnclosureCommand& command);

}  // namespace ff::app

#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/parser.hpp"

#include <functional>
#include <string_view>
#include <vector>

namespace ff::app {

/// Names for a value of this type ("SAMPLER").
using NamesOfType = std::function<std::vector<Listed>(std::string_view type)>;

/// Commands used by the build and by shells, hidden from help: `complete` and `man_pages`.
/// @param names  gives `complete` its names
void add_hidden_commands(ProgramDefinition& program, const NamesOfType& names);

}  // namespace ff::app

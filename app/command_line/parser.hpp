#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/command_line/command_model.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::app {

/// What a command line asks for.
struct ParsedCommandLine {
    const CommandDefinition* command = nullptr;  ///< whose options are filled in; null: only the text is asked for
    std::string text;                            ///< what --help, --version or no command at all prints
};

/// @param columns  that texts of help fit into
/// @throws UserError where the command line says what no definition allows
ParsedCommandLine parse(const ProgramDefinition& program, std::span<char* const> arguments, std::size_t columns);

/// The help of a command, or of the program where the name is empty. @throws UserError where there is no such command
std::string help_of(const ProgramDefinition& program, const std::string& command, std::size_t columns);

ProgramModel model_of(const ProgramDefinition& program);

}  // namespace ff::app

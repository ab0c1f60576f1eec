#pragma once

#include "app/command_line/command_definition.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ff::app {

// The command line as --help shows it, for man pages, completion and messages.

/// A name that a command line may have, and what it means.
struct Listed {
    std::string name;
    std::string summary;
};

/// An option, or an argument.
struct OptionModel {
    std::vector<std::string> names;  ///< "-q", "--quiet"; of an argument, "STUDY"
    std::string name;                ///< the name that messages use: "--quiet"
    std::string type;                ///< "SAMPLER" of "--sampler SAMPLER"; of an argument without one, its name
    std::string notes;               ///< what --help says after the names: " DIR"
    std::string usage;               ///< an argument as a synopsis shows it: "[STUDY]"
    std::string description;
    char delimiter = '\0';  ///< between its values; '\0': none
    bool is_argument = false;
    bool takes_value = false;
    bool takes_many = false;
};

struct CommandModel {
    std::string name;
    std::string description;
    std::vector<OptionModel> options;    ///< options that begin with dashes
    std::vector<OptionModel> arguments;  ///< positional arguments, in order
};

/// The command line without its hidden parts.
struct ProgramModel {
    CommandModel program;  ///< the options that stand before a command
    std::string footer;
    std::vector<CommandModel> commands;
};

inline std::vector<std::string> command_names(const ProgramModel& program) {
    std::vector<std::string> names;
    for (const CommandModel& command : program.commands) names.push_back(command.name);
    return names;
}

/// The request of a command line.
struct ParsedCommandLine {
    const CommandDefinition* command = nullptr;  ///< the one whose options are filled in; null: only text is asked for
    std::string text;                            ///< what --help, --version or no command at all prints
};

/// @param columns  width of the texts of help
/// @throws UserError where the command line says what no definition allows
ParsedCommandLine parse(const ProgramDefinition& program, std::span<char* const> arguments, std::size_t columns);

/// The help of a command, or of the program where the name is empty. @throws UserError where there is no such command
std::string help_of(const ProgramDefinition& program, const std::string& command, std::size_t columns);

ProgramModel model_of(const ProgramDefinition& program);

}  // namespace ff::app

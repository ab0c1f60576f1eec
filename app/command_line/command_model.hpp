#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

// The command line as --help shows it, for man pages, completion and messages.

/// An option, or an argument.
struct OptionModel {
    std::vector<std::string> names;  ///< "-q", "--quiet"; of an argument, "STUDY"
    std::string name;                ///< the one of messages: "--quiet"
    std::string type;                ///< "SAMPLER" of "--sampler SAMPLER"; empty: that of its name, or none
    std::string notes;               ///< what --help says behind the names: " DIR Needs: --out"
    std::string usage;               ///< how an argument stands in a synopsis: "[STUDY]"
    std::string description;
    char delimiter = '\0';  ///< between its values; '\0': none
    bool is_argument = false;
    bool takes_value = false;
    bool takes_many = false;
};

struct CommandModel {
    std::string name;
    std::string description;
    std::vector<OptionModel> options;  ///< and arguments, as they are defined
};

/// Without what is hidden.
struct ProgramModel {
    CommandModel program;  ///< the options that stand before a command
    std::string footer;
    std::vector<CommandModel> commands;
};

std::vector<std::string> command_names(const ProgramModel& program);

/// nullptr where there is no such command.
const CommandModel* find_command(const ProgramModel& program, std::string_view name);

/// Options that begin with dashes.
std::vector<const OptionModel*> options_of(const CommandModel& command);

/// Positional arguments, in order.
std::vector<const OptionModel*> arguments_of(const CommandModel& command);

/// The type of the value: "SAMPLER" of "--sampler SAMPLER"; for an argument without a type, its name.
std::string value_type(const OptionModel& option);

}  // namespace ff::app

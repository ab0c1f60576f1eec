#include "app/command_line/command_model.hpp"

namespace ff::app {
namespace {

std::vector<const OptionModel*> options_where(const CommandModel& command, bool are_arguments) {
    std::vector<const OptionModel*> found;
    for (const OptionModel& option : command.options) {
        if (option.is_argument == are_arguments) found.push_back(&option);
    }
    return found;
}

}  // namespace

std::vector<std::string> command_names(const ProgramModel& program) {
    std::vector<std::string> names;
    for (const CommandModel& command : program.commands) names.push_back(command.name);
    return names;
}

const CommandModel* find_command(const ProgramModel& program, std::string_view name) {
    for (const CommandModel& command : program.commands) {
        if (command.name == name) return &command;
    }
    return nullptr;
}

std::vector<const OptionModel*> options_of(const CommandModel& command) {
    return options_where(command, false);
}

std::vector<const OptionModel*> arguments_of(const CommandModel& command) {
    return options_where(command, true);
}

std::string value_type(const OptionModel& option) {
    return option.is_argument && option.type.empty() ? option.name : option.type;
}

}  // namespace ff::app

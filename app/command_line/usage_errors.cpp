#include "app/command_line/usage_errors.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace ff::app {
namespace {

/// What was given: one of the commands, or only the program.
struct Given {
    const ProgramModel& program;
    const CommandModel& command;

    [[nodiscard]] bool is_commanded() const { return &command != &program.program; }
};

std::string where_help_is(const Given& given) {
    return given.is_commanded() ? fmt::format("See 'ffstudy {} --help'.", given.command.name) : "See 'ffstudy --help'.";
}

std::vector<std::string> long_names_of_options(const CommandModel& command) {
    std::vector<std::string> names;
    for (const OptionModel& option : command.options) {
        std::copy_if(option.names.begin(), option.names.end(), std::back_inserter(names),
                     [](const std::string& name) { return name.starts_with("--"); });
    }
    return names;
}

std::string unknown(std::string_view what, const std::string& argument, const std::vector<std::string>& names,
                    const Given& given) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    return fmt::format("unknown {} '{}'. {}{}", what, argument, did_you_mean(argument, known), where_help_is(given));
}

/// A file where a command is wanted, with the command that takes it; empty where the word names no file of ours.
std::string file_as_command(const std::string& word) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(word, error)) return {};
    constexpr std::size_t enough = 1 << 16;
    std::string bytes(enough, '\0');
    std::ifstream file(word, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(enough));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    const auto kind = studies::kind_of(bytes);
    if (!kind) return {};
    return fmt::format("'{}' is {}, not a command. Run '{}'.", word, studies::name_of(*kind),
                       studies::command_for(*kind, word));
}

std::string unexpected(const Given& given, const std::vector<std::string>& rest) {
    const auto is_option = [](const std::string& argument) { return argument.starts_with('-'); };
    // Without a command, every option is unknown: the word that should have been one comes first.
    if (!given.is_commanded() && !is_option(rest.front())) {
        const std::string told = file_as_command(rest.front());
        return told.empty() ? unknown("command", rest.front(), command_names(given.program), given) : told;
    }
    const auto option = std::find_if(rest.begin(), rest.end(), is_option);
    if (option != rest.end()) return unknown("option", *option, long_names_of_options(given.command), given);
    return fmt::format("'{}' is one argument too many. {}", rest.front(), where_help_is(given));
}

bool counts(const OptionModel& option) {
    return option.type == "UINT";
}

std::string no_number(const OptionModel& option, std::string_view value) {
    return counts(option)
               ? fmt::format("{} {} (not a whole number from 0 to 2^64 - 1). Write it like 1000.", option.name, value)
               : fmt::format("{} {} (not a number). Write it like 0.001.", option.name, value);
}

/// The parser's "Could not convert: --trials = 1e3", in our words.
std::string not_converted(const Given& given, std::string_view message) {
    for (const OptionModel& option : given.command.options) {
        const std::string beginning = fmt::format(": {} = ", option.name);
        const auto found = message.find(beginning);
        if (found != std::string_view::npos) return no_number(option, message.substr(found + beginning.size()));
    }
    return fmt::format("{}. {}", message, where_help_is(given));
}

}  // namespace

std::string usage_problem(const ProgramModel& program, const CommandModel& command, const UsageFault& fault) {
    const Given given{program, command};
    const std::string& message = fault.message;
    switch (fault.kind) {
        case UsageFault::Kind::unexpected:
            return unexpected(given, fault.rest);
        case UsageFault::Kind::not_converted:
            return not_converted(given, message);
        case UsageFault::Kind::missing:
            return fmt::format("{} is missing. {}", message.substr(0, message.find(" is ")), where_help_is(given));
        case UsageFault::Kind::number_of_values:
            return fmt::format("{} needs one value. Give it once. {}", message.substr(0, message.find(':')),
                               where_help_is(given));
        case UsageFault::Kind::other:
            break;
    }
    return fmt::format("{}. {}", message, where_help_is(given));
}

void refuse_unmeant_values(const OptionModel& option, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
        if (counts(option) && value.starts_with('-')) throw UserError(no_number(option, value));
        if (!value.empty()) continue;
        throw UserError(fmt::format("{} is empty (it would silently mean the default). Give a value{}.", option.name,
                                    option.is_argument ? "" : ", or leave the option out"));
    }
}

}  // namespace ff::app

#include "app/command_line/usage_errors.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ff::app {
namespace {

std::vector<std::string> long_names_of_options(const CommandModel& command) {
    std::vector<std::string> names;
    for (const OptionModel& option : command.options) {
        std::ranges::copy_if(option.names, std::back_inserter(names),
                             [](const std::string& name) { return name.starts_with("--"); });
    }
    return names;
}

/// The message for a file in place of a command, with the command that takes it; empty where the word does not name one
/// of our files.
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

bool counts(const OptionModel& option) {
    return option.type == "UINT";
}

std::string no_number(const OptionModel& option, std::string_view value) {
    return counts(option)
               ? fmt::format("{} {} (not a whole number from 0 to 2^64 - 1). Write it like 1000.", option.name, value)
               : fmt::format("{} {} (not a number). Write it like 0.001.", option.name, value);
}

}  // namespace

std::string UsageProblems::where_help_is() const {
    return command == nullptr ? "See 'ffstudy --help'." : fmt::format("See 'ffstudy {} --help'.", command->name);
}

std::string UsageProblems::unknown(std::string_view what, const std::string& word,
                                   const std::vector<std::string>& names) const {
    const std::vector<std::string_view> known(names.begin(), names.end());
    return fmt::format("unknown {} '{}'. {}{}", what, word, did_you_mean(word, known), where_help_is());
}

std::string UsageProblems::unexpected(const std::vector<std::string>& words) const {
    const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
    // Without a command, every option is unknown: the word that should have been one comes first.
    if (command == nullptr && !is_option(words.front())) {
        const std::string told = file_as_command(words.front());
        return told.empty() ? unknown("command", words.front(), command_names(program)) : told;
    }
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    if (option == words.end()) return fmt::format("'{}' is one argument too many. {}", words.front(), where_help_is());
    return unknown("option", *option, long_names_of_options(command == nullptr ? program.program : *command));
}

/// The parser's "Could not convert: --trials = 1e3", in our words.
std::string UsageProblems::not_converted(std::string_view message) const {
    for (const OptionModel& option : (command == nullptr ? program.program : *command).options) {
        const std::string beginning = fmt::format(": {} = ", option.name);
        const auto found = message.find(beginning);
        if (found != std::string_view::npos) return no_number(option, message.substr(found + beginning.size()));
    }
    return other(message);
}

std::string UsageProblems::missing(std::string_view message) const {
    return fmt::format("{} is missing. {}", message.substr(0, message.find(" is ")), where_help_is());
}

std::string UsageProblems::number_of_values(std::string_view message) const {
    return fmt::format("{} needs one value. Give it once. {}", message.substr(0, message.find(':')), where_help_is());
}

std::string UsageProblems::other(std::string_view message) const {
    return fmt::format("{}. {}", message, where_help_is());
}

void refuse_unmeant_values(const OptionModel& option, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
        if (counts(option) && value.starts_with('-')) throw UserError(no_number(option, value));
        if (!value.empty()) continue;
        throw UserError("{} is empty (it would silently mean the default). Give a value{}.", option.name,
                        option.is_argument ? "" : ", or leave the option out");
    }
}

}  // namespace ff::app

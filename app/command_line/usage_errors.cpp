#include "app/command_line/usage_errors.hpp"

#include "app/command_line/command_model.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace ff::app {
namespace {

/// The command that was given; the program itself where there is none.
const CLI::App& given_command(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : *commands.front();
}

std::string help_of(const CLI::App& app) {
    const CLI::App& command = given_command(app);
    return &command == &app ? "See 'ffstudy --help'." : fmt::format("See 'ffstudy {} --help'.", command.get_name());
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

std::string unknown(std::string_view what, const std::string& argument, const std::vector<std::string>& names,
                    const CLI::App& app) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    return fmt::format("unknown {} '{}'. {}{}", what, argument, did_you_mean(argument, known), help_of(app));
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

std::string unexpected(const CLI::App& app) {
    const auto rest = app.remaining(true);
    const auto is_option = [](const std::string& argument) { return argument.starts_with('-'); };
    const CLI::App& command = given_command(app);
    const bool commanded = &command != &app;
    // Without a command, every option is unknown: the word that should have been one comes first.
    if (!commanded && !is_option(rest.front())) {
        const std::string told = file_as_command(rest.front());
        return told.empty() ? unknown("command", rest.front(), command_names(app), app) : told;
    }
    const auto option = std::find_if(rest.begin(), rest.end(), is_option);
    if (option != rest.end()) return unknown("option", *option, option_names(command), app);
    return fmt::format("'{}' is one argument too many. {}", rest.front(), help_of(app));
}

bool counts(const CLI::Option& option) {
    return option.get_type_name() == "UINT";
}

std::string no_number(const CLI::Option& option, std::string_view value) {
    return counts(option) ? fmt::format("{} {} (not a whole number from 0 to 2^64 - 1). Write it like 1000.",
                                        option.get_name(), value)
                          : fmt::format("{} {} (not a number). Write it like 0.001.", option.get_name(), value);
}

/// The parser's "Could not convert: --trials = 1e3", in our words.
std::string not_converted(const CLI::App& app, std::string_view message) {
    for (const CLI::Option* option : given_command(app).get_options()) {
        const std::string given = fmt::format(": {} = ", option->get_name());
        const auto found = message.find(given);
        if (found != std::string_view::npos) return no_number(*option, message.substr(found + given.size()));
    }
    return fmt::format("{}. {}", message, help_of(app));
}

}  // namespace

std::string usage_problem(const CLI::App& app, const CLI::ParseError& error) {
    const std::string message = error.what();
    const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
    if (is(CLI::ExitCodes::ExtrasError)) return unexpected(app);
    if (is(CLI::ExitCodes::ConversionError)) return not_converted(app, message);
    if (is(CLI::ExitCodes::RequiredError))
        return fmt::format("{} is missing. {}", message.substr(0, message.find(" is ")), help_of(app));
    if (is(CLI::ExitCodes::ArgumentMismatch))
        return fmt::format("{} needs one value. Give it once. {}", message.substr(0, message.find(':')), help_of(app));
    return fmt::format("{}. {}", message, help_of(app));
}

void refuse_unmeant_values(const CLI::App& app) {
    for (const CLI::Option* option : given_command(app).get_options()) {
        for (const std::string& value : option->results()) {
            if (counts(*option) && value.starts_with('-')) throw UserError(no_number(*option, value));
            if (!value.empty()) continue;
            throw UserError(fmt::format("{} is empty (it would silently mean the default). Give a value{}.",
                                        option->get_name(),
                                        option->get_positional() ? "" : ", or leave the option out"));
        }
    }
}

}  // namespace ff::app

#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

// The definitions of the command line, as read by help, man pages and completion. Anything without a group is hidden.

std::vector<const CLI::App*> shown_commands(const CLI::App& app);

std::vector<std::string> command_names(const CLI::App& app);

/// nullptr where there is no such command.
const CLI::App* find_command(const CLI::App& app, std::string_view name);

/// The help of a command, or of the program where the name is empty. @throws UserError where there is no such command
std::string help_of_command(const CLI::App& app, const std::string& name);

/// Options that begin with dashes.
std::vector<const CLI::Option*> shown_options(const CLI::App& command);

/// Positional arguments, in order.
std::vector<const CLI::Option*> shown_arguments(const CLI::App& command);

bool is_flag(const CLI::Option& option);
bool takes_many(const CLI::Option& argument);

/// The type of the value: "SAMPLER" of "--sampler SAMPLER"; for an argument without a type, its name.
std::string value_type(const CLI::Option& option);

/// Lets the names of arguments stand for their types, so that help says "STUDY", not "STUDY TEXT".
void name_types_of_arguments(CLI::App& app);

/// Breaks the descriptions of commands and options into lines, so that help fits into this many columns. For help only:
/// the breaks stay in the definitions.
void fit_descriptions(CLI::App& app, std::size_t columns);

}  // namespace ff::app

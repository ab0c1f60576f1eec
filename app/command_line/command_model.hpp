#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

// The definitions of the command line, as help, man pages and completion read them. What has no group is hidden.

std::vector<const CLI::App*> shown_commands(const CLI::App& app);

std::vector<std::string> command_names(const CLI::App& app);

/// nullptr where there is no such command.
const CLI::App* find_command(const CLI::App& app, std::string_view name);

/// The help of a command; that of the program where the name is empty. @throws UserError where there is no such command
std::string help_of_command(const CLI::App& app, const std::string& name);

/// Those that begin with dashes.
std::vector<const CLI::Option*> shown_options(const CLI::App& command);

/// Those that have a place instead, in order.
std::vector<const CLI::Option*> shown_arguments(const CLI::App& command);

bool is_flag(const CLI::Option& option);
bool takes_many(const CLI::Option& argument);

/// What is taken: "SAMPLER" of "--sampler SAMPLER"; an argument's name says it unless its type does.
std::string value_type(const CLI::Option& option);

/// Lets the names of arguments stand for their types, so that help says "STUDY", not "STUDY TEXT".
void name_types_of_arguments(CLI::App& app);

}  // namespace ff::app

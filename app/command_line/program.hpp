#pragma once

#include "app/command_line/action.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <span>
#include <string>

namespace ff::app {

/// The groups of commands in --help.
inline constexpr const char* everyday = "Everyday";
inline constexpr const char* laboratory = "Laboratory";
inline constexpr const char* checks = "Checks";
inline constexpr const char* built_in = "Built-in studies";

CLI::App* add_command(CLI::App& app, const char* group, std::string name, std::string summary);

/// The options -q and -v. @param quiet_prints  what is still printed with -q
void add_verbosity(CLI::App& command, bool& quiet, const std::string& quiet_prints = "Print errors only");

/// `ffstudy help COMMAND`
void add_help(CLI::App& app, Action& action);

/// All of main: signals, the command line, the requested command, the exit code.
/// @param add  adds all commands, which set the action
int run_program(std::span<char*> arguments, const std::string& summary,
                const std::function<void(CLI::App& app, Action& action)>& add);

}  // namespace ff::app

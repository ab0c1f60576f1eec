#pragma once

#include "app/command_line/command_definition.hpp"

#include <functional>
#include <span>
#include <string>

namespace ff::app {

/// The groups of commands in --help.
inline constexpr const char* everyday = "Everyday";
inline constexpr const char* laboratory = "Laboratory";
inline constexpr const char* checks = "Checks";
inline constexpr const char* built_in = "Built-in studies";
inline constexpr const char* hidden = "";

/// Adds the options -q and -v. @param quiet_prints  what is still printed with -q
void add_verbosity(CommandDefinition& command, bool& quiet, const std::string& quiet_prints = "Print errors only");

/// `ffstudy help COMMAND`
void add_help(ProgramDefinition& program);

/// All of main: signals, the command line, the requested command, the exit code.
/// @param add  adds the definitions of all commands
int run_program(std::span<char*> arguments, const std::string& summary,
                const std::function<void(ProgramDefinition& program)>& add);

}  // namespace ff::app

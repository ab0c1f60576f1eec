#pragma once

#include "studies/outside/outside_code.hpp"
#include "studies/readers/file_kind.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// What the command line says of code from outside.
struct OutsideOptions {
    std::vector<std::filesystem::path> plugins;
    std::optional<std::string> deadline;  ///< of a program, for a set of points: "90", "5m"
    bool no_commands = false;             ///< study files load and run nothing
};

/// What a command runs: only what its own line names, or what a study file names as well.
enum class OutsideCodeFrom { plugins, command_line, files_too };

void add_outside_options(CLI::App& command, OutsideOptions& options, OutsideCodeFrom from);

/// Seconds. @throws UserError
double deadline_of(const OutsideOptions& options);

/// Loads the plug-ins of the command line. @throws UserError, IoError
void load_plugins(const OutsideOptions& options);

/// Whether it is said what a file wants run.
enum class Announcement { said, silent };

/// Loads the plug-ins of the command line, then admits what a study file or bands file wants run, each with a word
/// before. @throws UserError where the command line refuses it; IoError
void admit_code_of(const std::filesystem::path& file, studies::FileKind kind, const OutsideOptions& options,
                   Announcement announcement = Announcement::said);

}  // namespace ff::app

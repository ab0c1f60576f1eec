#pragma once

#include "core/points/stream.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/readers/text_file.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

// Options that several commands take. All @throws UserError.

/// The seed of --seed.
Seed checked_seed(std::uint64_t seed);

/// A fresh seed.
Seed fresh_seed();

/// Threads of --threads; all cores by default.
unsigned thread_count(const std::optional<unsigned>& threads);

struct CommandDefinition;

/// Command-line options about outside code.
struct OutsideOptions {
    std::vector<std::filesystem::path> plugins;
    std::optional<std::string> deadline;  ///< time for a program to give one set of points: "90" (seconds), "5m"
    bool no_commands = false;             ///< study files load and run nothing
};

/// Which outside code a command may run: only what its command line names, or also what a study file names.
enum class OutsideCodeFrom { plugins, command_line, files_too };

void add_outside_options(CommandDefinition& command, OutsideOptions& options, OutsideCodeFrom from);

/// Seconds. @throws UserError
double deadline_of(const OutsideOptions& options);

/// Loads the plug-ins of the command line. @throws UserError, IoError
void load_plugins(const OutsideOptions& options);

/// Whether to announce the code that a file asks to run.
enum class Announcement { said, silent };

/// Loads the plug-ins of the command line, then admits the code that a study file or bands file asks to run, announcing
/// each. @throws UserError where the command line refuses it; IoError
void admit_code_of(const std::filesystem::path& file, studies::FileKind kind, const OutsideOptions& options,
                   Announcement announcement = Announcement::said);

}  // namespace ff::app

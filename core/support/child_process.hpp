#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ff {

/// A program to be started.
struct ChildCommand {
    std::vector<std::string> words;  ///< the program, looked for on PATH unless it has a slash, and its arguments
    std::filesystem::path folder;    ///< where it runs; empty: here
};

/// Whether signals of the terminal, as Ctrl-C sends them, reach a child too.
enum class ChildSignals { as_usual, none };

/// Descriptors that a child has as its own.
struct ChildStreams {
    int input;
    int output;
    int errors;
};

/// Starts a program. It ends where this process is killed; nobody waits for it here. @throws IoError
pid_t start_child(const ChildCommand& command, ChildStreams streams, ChildSignals signals);

/// Waits for its end. @return as waitpid tells it
int wait_for_child(pid_t child);

/// What a program has printed, and how it ended.
struct ChildOutput {
    enum class End {
        exited,     ///< `code` is its exit code
        killed,     ///< `code` is the signal
        too_slow,   ///< it did not end before the deadline, and was killed
        too_large,  ///< it printed more than was wanted, and was killed
    };
    End end = End::exited;
    int code = 0;
    std::string output;
    std::string errors;  ///< the last of what it wrote to stderr
};

/// Runs a program without input, and reads what it prints. The terminal's signals do not reach it.
/// @param most_output  bytes  @param deadline  seconds, above 0  @throws IoError where it cannot be started
ChildOutput read_from_child(const ChildCommand& command, std::uint64_t most_output, double deadline);

}  // namespace ff

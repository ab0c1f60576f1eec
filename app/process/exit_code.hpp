#pragma once

namespace ff::app {

/// Exit codes, the same for all commands (docs/command-line.md).
enum class ExitCode {
    passed = 0,
    failed = 1,  ///< out of tolerance, or a contradiction found
    usage = 2,   ///< usage or input
    io = 3,      ///< a file cannot be read or written
    inconclusive = 4,
    interrupted = 130,  ///< interrupted or out of time; completed work is saved
};

}  // namespace ff::app

#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// A program to be started.
struct ChildCommand {
    std::vector<std::string> words;  ///< the program, looked for on PATH unless it has a slash, and its arguments
    std::filesystem::path folder;    ///< where it runs; empty: here
};

/// Whether signals of the terminal, as Ctrl-C sends them, reach a child too.
enum class ChildSignals { as_usual, none };

/// Descriptors that a child inherits as its own.
struct ChildStreams {
    int input;
    int output;
    int errors;
};

/// Starts a program without waiting for it. It is killed with this process. @throws IoError
pid_t start_child(const ChildCommand& command, ChildStreams streams, ChildSignals signals);

/// Waits for its end. @return the status of waitpid
int wait_for_child(pid_t child);

/// The output of a program, and how it ended.
struct ChildOutput {
    enum class End {
        exited,     ///< `code` is its exit code
        killed,     ///< `code` is the signal
        too_slow,   ///< it did not end before the deadline, and was killed
        too_large,  ///< it printed more than allowed, and was killed
    };
    End end = End::exited;
    int code = 0;
    std::string output;
    std::string errors;  ///< the last of what it wrote to stderr
};

/// Runs a program without input, and reads what it prints. The terminal's signals do not reach it.
/// @param most_output  bytes  @param deadline  seconds, above 0  @throws IoError where it cannot be started
ChildOutput read_from_child(const ChildCommand& command, std::uint64_t most_output, double deadline);

/// A program that answers requests: one line each on its standard input, bytes on its standard output. It ends with
/// this object. The terminal's signals do not reach it. Has to be used, and destroyed, in the thread that made it.
class ChildConversation {
  public:
    /// @throws IoError where it cannot be started
    explicit ChildConversation(const ChildCommand& command);
    ~ChildConversation();
    ChildConversation(const ChildConversation&) = delete;
    ChildConversation& operator=(const ChildConversation&) = delete;

    /// Total bytes of an answer, as its beginning tells.
    using Size = std::function<std::uint64_t(std::string_view beginning)>;

    /// The answer to a line, or how the program ended instead: `exited` with the answer whole where `output` has as
    /// many bytes as `size` says. Any other outcome ends the conversation.
    /// @param most_output  bytes  @param deadline  seconds, above 0
    [[nodiscard]] ChildOutput ask(std::string_view line, const Size& size, std::uint64_t most_output, double deadline);

  private:
    struct Ends;
    std::string program_;
    std::unique_ptr<Ends> ends_;
};

}  // namespace ff

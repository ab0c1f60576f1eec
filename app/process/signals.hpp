#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace ff::app {

/// From the first instruction of main on, SIGINT, SIGTERM and SIGUSR1 are received by a thread of its own. They end the
/// program promptly, wherever it is, after the actions of OnEnd objects; exit code 130.
void receive_signals();

/// The message printed then; none where nothing was begun.
void end_on_signals(std::string words);

/// Used around work that is worth saving: the first signal only sets the flag, a second ends the program.
/// @param words  printed to stderr by the first
void stop_gracefully_on_signals(std::string words = {});

/// Used in a process that another one waits for: signals only set the flag and never end the program.
void never_end_on_signals();

/// Whether a graceful stop is requested.
const std::atomic<bool>& stop_flag();

/// Set two seconds later: do not wait for work in progress any longer.
const std::atomic<bool>& drop_flag();

/// Sets the flags like a first signal.
void ask_for_the_end();

/// During its lifetime, a signal that ends the program first calls `action`; any thread may hold any lock then.
class OnEnd {
  public:
    explicit OnEnd(std::function<void()> action);
    ~OnEnd();
    OnEnd(const OnEnd&) = delete;
    OnEnd& operator=(const OnEnd&) = delete;

  private:
    std::function<void()> action_;
};

/// Called at the end of main: an earlier signal decides the exit code, a later one has no effect.
void close_to_signals();

/// Makes a file that exceeds the system's limit fail as on a full disk, and a pipe without a reader as a closed file,
/// instead of ending the program.
void turn_output_signals_into_errors();

}  // namespace ff::app

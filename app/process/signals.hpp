#pragma once

#include <atomic>
#include <functional>
#include <string>

namespace ff::app {

/// From the first instruction of main on, SIGINT, SIGTERM and SIGUSR1 are received by a thread of its own. They end the
/// program within a moment, wherever it is, after what OnEnd objects do; exit code 130.
void receive_signals();

/// What is said when they do. Where nothing is said, nothing was begun.
void end_on_signals(std::string words);

/// For work that is worth saving: the first signal only sets the flag, a second ends the program.
void stop_in_order_on_signals();

/// For a process that another one waits for: signals set the flag and never end the program.
void never_end_on_signals();

/// Whether an orderly end is asked for.
const std::atomic<bool>& stop_flag();

/// Set two seconds after it: what is in hand is not waited for any longer.
const std::atomic<bool>& drop_flag();

/// Sets the flags as a first signal does.
void ask_for_the_end();

/// While it lives, a signal that ends the program calls `action` before; any thread may have any lock then.
class OnEnd {
  public:
    explicit OnEnd(std::function<void()> action);
    ~OnEnd();
    OnEnd(const OnEnd&) = delete;
    OnEnd& operator=(const OnEnd&) = delete;

  private:
    std::function<void()> action_;
};

/// At the end of main: a signal that has come before decides on the exit code, a later one does nothing.
void close_to_signals();

/// A file that outgrows the limit of the system then fails as on a full disk, and a pipe that nobody reads any more as
/// a closed file, instead of ending the program.
void turn_output_signals_into_errors();

}  // namespace ff::app

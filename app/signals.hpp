#pragma once

#include <atomic>

namespace ff::app {

/// Makes SIGINT, SIGTERM and SIGUSR1 ask for an orderly end: the first sets the flag, a second ends at once (130).
/// @return the flag
const std::atomic<bool>& stop_on_signals();

/// A flag that is set two seconds after the first: what is in hand is not waited for any longer.
const std::atomic<bool>& drop_on_signals();

/// Sets the flags as a first signal does.
void ask_for_the_end();

/// From here on these signals end the program at once (130); nothing is left that could be lost.
void end_on_signals();

/// A file that outgrows the limit of the system then fails as on a full disk, and a pipe that nobody reads any more as
/// a closed file, instead of ending the program.
void turn_output_signals_into_errors();

}  // namespace ff::app

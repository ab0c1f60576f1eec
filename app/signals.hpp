#pragma once

#include <atomic>

namespace ff::app {

/// Makes SIGINT, SIGTERM and SIGUSR1 ask for an orderly end: the first sets the flag, a second ends at once (130).
/// @return the flag
const std::atomic<bool>& stop_on_signals();

/// From here on these signals end the program at once; nothing is left that could be lost.
void end_on_signals();

}  // namespace ff::app

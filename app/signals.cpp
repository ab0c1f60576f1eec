#include "app/signals.hpp"

#include "app/exit_code.hpp"

#include <unistd.h>
#include <csignal>

namespace ff::app {
namespace {

std::atomic<bool> stop{false};
std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

extern "C" void handle(int /*signal*/) {
    stop = true;
    if (signalled.exchange(true)) ::_exit(static_cast<int>(ExitCode::interrupted));
}

/// All that is worth saving is saved; the exit code is the documented one.
extern "C" void leave(int /*signal*/) {
    ::_exit(static_cast<int>(ExitCode::interrupted));
}

void set_handler(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) {
        struct sigaction action {};
        action.sa_handler = handler;
        action.sa_flags = SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
    set_handler(handle);
    return stop;
}

void ask_for_the_end() {
    stop = true;
}

void end_on_signals() {
    set_handler(leave);
}

void turn_file_size_signal_into_errors() {
    std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace ff::app

#include "app/signals.hpp"

#include "app/exit_code.hpp"

#include <unistd.h>
#include <csignal>

namespace ff::app {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

extern "C" void handle(int /*signal*/) {
    if (stop.exchange(true)) ::_exit(static_cast<int>(ExitCode::interrupted));
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) {
        struct sigaction action {};
        action.sa_handler = handle;
        action.sa_flags = SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
    return stop;
}

}  // namespace ff::app

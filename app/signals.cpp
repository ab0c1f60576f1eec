#include "app/signals.hpp"

#include "app/exit_code.hpp"

#include <unistd.h>
#include <csignal>
#include <string_view>

namespace ff::app {
namespace {

std::atomic<bool> stop{false};
std::atomic<bool> drop{false};
std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

/// Seconds that units in hand have to be finished.
constexpr unsigned patience = 2;

extern "C" void handle(int /*signal*/) {
    ask_for_the_end();
    if (signalled.exchange(true)) ::_exit(static_cast<int>(ExitCode::interrupted));
}

extern "C" void lose_patience(int /*signal*/) {
    drop = true;
}

/// All that is worth saving is saved; the exit code is the documented one.
extern "C" void leave(int /*signal*/) {
    constexpr std::string_view words =
        "\nstopped while results were evaluated or written. What was found is saved: the same command goes on.\n";
    // Where it cannot be said it is not.
    if (::write(STDERR_FILENO, words.data(), words.size()) < 0) ::_exit(static_cast<int>(ExitCode::interrupted));
    ::_exit(static_cast<int>(ExitCode::interrupted));
}

void set_handler(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void set_handler(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) set_handler(signal, handler);
    set_handler(SIGALRM, lose_patience);
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
    set_handler(handle);
    return stop;
}

const std::atomic<bool>& drop_on_signals() {
    return drop;
}

void ask_for_the_end() {
    stop = true;
    ::alarm(patience);
}

void end_on_signals() {
    set_handler(leave);
}

void turn_output_signals_into_errors() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace ff::app

#include "app/process/signals.hpp"

#include "app/process/exit_code.hpp"

#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <mutex>
#include <utility>
#include <vector>

namespace ff::app {
namespace {

enum class Meaning { end, stop_then_end, stop };

/// Shared with the thread that receives signals, which lives as long as the process.
struct State {
    std::atomic<bool> stop{false};
    std::atomic<bool> drop{false};
    std::mutex mutex;  // guards the members below
    Meaning meaning = Meaning::end;
    bool signalled = false;
    std::string words;
    std::vector<const std::function<void()>*> actions;
};

State& state() {
    static State& never_destroyed = *new State;
    return never_destroyed;
}

/// Seconds in which units in progress have to be finished.
constexpr unsigned seconds_to_finish = 2;

constexpr std::array received{SIGINT, SIGTERM, SIGUSR1};

sigset_t received_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : received) sigaddset(&signals, signal);
    sigaddset(&signals, SIGALRM);
    return signals;
}

void mean(Meaning meaning, std::string words = {}) {
    const std::lock_guard lock(state().mutex);
    state().meaning = meaning;
    state().words = std::move(words);
}

/// Prints the meaning of a signal, once. A failure to print is ignored.
void say_words() {
    const std::string words = std::exchange(state().words, {});
    if (!words.empty()) static_cast<void>(!::write(STDERR_FILENO, words.data(), words.size()));
}

/// The mutex stays locked, so that no other thread keeps using what the actions take away.
[[noreturn]] void end() {
    for (auto action = state().actions.rbegin(); action != state().actions.rend(); ++action) (**action)();
    say_words();
    ::_exit(static_cast<int>(ExitCode::interrupted));
}

void* receive(void* /*nothing*/) {
    const sigset_t signals = received_signals();
    while (true) {
        int signal = 0;
        if (sigwait(&signals, &signal) != 0) continue;
        if (signal == SIGALRM) {
            state().drop = true;
            continue;
        }
        std::unique_lock lock(state().mutex);
        const bool first = !state().signalled;
        state().signalled = true;
        if (state().meaning == Meaning::end || (state().meaning == Meaning::stop_then_end && !first)) {
            lock.release();
            end();
        }
        if (state().meaning == Meaning::stop_then_end) say_words();
        ask_for_the_end();
    }
}

}  // namespace

void receive_signals() {
    const sigset_t signals = received_signals();
    // Every thread that is started from here on inherits the mask.
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    constexpr std::size_t stack = std::size_t{1} << 20;  // whatever limit the user has set
    pthread_attr_setstacksize(&attributes, stack);
    pthread_t thread{};
    if (pthread_create(&thread, &attributes, receive, nullptr) != 0) {
        // Signals then end the program as they end any other, and nothing is dropped.
        std::signal(SIGALRM, SIG_IGN);
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
    pthread_attr_destroy(&attributes);
}

void end_on_signals(std::string words) {
    mean(Meaning::end, std::move(words));
}

void stop_gracefully_on_signals(std::string words) {
    mean(Meaning::stop_then_end, std::move(words));
}

void never_end_on_signals() {
    mean(Meaning::stop);
}

const std::atomic<bool>& stop_flag() {
    return state().stop;
}

const std::atomic<bool>& drop_flag() {
    return state().drop;
}

void ask_for_the_end() {
    state().stop = true;
    ::alarm(seconds_to_finish);
}

OnEnd::OnEnd(std::function<void()> action) : action_(std::move(action)) {
    const std::lock_guard lock(state().mutex);
    state().actions.push_back(&action_);
}

OnEnd::~OnEnd() {
    const std::lock_guard lock(state().mutex);
    std::erase(state().actions, &action_);
}

void close_to_signals() {
    state().mutex.lock();
}

void turn_output_signals_into_errors() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace ff::app

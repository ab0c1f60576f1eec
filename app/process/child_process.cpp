#include "app/process/child_process.hpp"

#include "app/process/signals.hpp"

#include "core/support/child_process.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace ff::app {

std::filesystem::path find_program(std::string_view name) {
    const char* const search = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): nobody sets it
    std::string_view rest = search == nullptr ? std::string_view() : search;
    while (!rest.empty()) {
        const auto end = std::min(rest.find(':'), rest.size());
        auto program = std::filesystem::path(rest.substr(0, end)) / name;
        if (end > 0 && ::access(program.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(program))
            return program;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

void run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::function<void()>& meanwhile) {
    ChildCommand command{{program.string()}, {}};
    command.words.insert(command.words.end(), arguments.begin(), arguments.end());
    const pid_t child = start_child(command, {STDIN_FILENO, STDERR_FILENO, STDERR_FILENO}, ChildSignals::as_usual);
    const OnEnd end_child([child] { ::kill(child, SIGKILL); });
    const auto runs = [child] {
        siginfo_t ended{};
        return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    };
    while (meanwhile && runs()) {
        meanwhile();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    const int status = wait_for_child(child);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw IoError(
            fmt::format("{}: failed (its message is above). Check the disk and the memory.", program.string()));
}

}  // namespace ff::app

#include "app/process/child_process.hpp"

#include "app/process/signals.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace ff::app {
namespace {

constexpr int not_started = 127;

/// Between fork and exec only what a signal handler may do as well. What the program says goes to stderr; it takes
/// signals as usual, and ends where this process is killed.
[[noreturn]] void become(char* const* argv, pid_t parent) {
    sigset_t none;
    sigemptyset(&none);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() == parent && ::dup2(STDERR_FILENO, STDOUT_FILENO) >= 0 &&
        ::sigprocmask(SIG_SETMASK, &none, nullptr) == 0) {
        std::signal(SIGPIPE, SIG_DFL);
        std::signal(SIGXFSZ, SIG_DFL);
        ::execv(argv[0], argv);
    }
    ::_exit(not_started);
}

}  // namespace

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

void run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::string name = program.string();
    std::vector<std::string> kept = arguments;
    std::vector<char*> argv{name.data()};
    for (std::string& argument : kept) argv.push_back(argument.data());
    argv.push_back(nullptr);

    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) become(argv.data(), parent);
    if (child < 0) {
        throw IoError(fmt::format("{}: cannot be started ({}). Check its installation.", name,
                                  std::generic_category().message(errno)));
    }
    const OnEnd end_child([child] { ::kill(child, SIGKILL); });
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == not_started)
        throw IoError(fmt::format("{}: cannot be started. Check its installation.", name));
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw IoError(fmt::format("{}: failed (its message is above). Check the disk and the memory.", name));
}

}  // namespace ff::app

#include "app/child_process.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

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

void run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::string name = program.string();
    std::vector<std::string> kept = arguments;
    std::vector<char*> argv{name.data()};
    for (std::string& argument : kept) argv.push_back(argument.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, name.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        throw IoError(fmt::format("{}: cannot be started ({}). Check its installation.", name,
                                  std::generic_category().message(failed)));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw IoError(fmt::format("{}: failed (its message is above). Check the disk and the memory.", name));
}

}  // namespace ff::app

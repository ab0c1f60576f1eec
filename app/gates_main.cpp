// The smaller program (-DFFSTUDY_GATES_ONLY=ON): gates on what other programs report. It is built from what this file
// includes, directly or not, and from nothing else (cmake/FfGatesOnly.cmake).

#include "app/command_line/program.hpp"
#include "app/commands/gates/gate_commands.hpp"
#include "app/commands/hidden_commands.hpp"

namespace {

using namespace ff::app;

void add_commands(ProgramDefinition& program) {
    add_check_of_files(program);
    add_help(program);
    add_hidden_commands(program, [](std::string_view) { return std::vector<Listed>(); });
}

}  // namespace

// A failure while an error is being reported ends in the handler that `guarded` sets.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    return run_program({argv, static_cast<std::size_t>(argc)}, "Gates on what Monte Carlo codes report.", add_commands);
}

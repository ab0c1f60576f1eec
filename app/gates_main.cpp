// The smaller program (-DFFSTUDY_GATES_ONLY=ON): gates on what other programs report. It is built from what this file
// includes, directly or not, and from nothing else (cmake/FfGatesOnly.cmake).

#include "app/command_line/program.hpp"
#include "app/commands/gate_commands.hpp"
#include "app/commands/hidden_commands.hpp"

namespace {

using namespace ff::app;

struct Commands {
    CheckCommand check;
    TrendCommand trend;
};

void add_commands(ProgramDefinition& program, Commands& commands) {
    add_check_of_files(program, commands.check).action = [&] { return check_files(commands.check); };
    add_trend(program, commands.trend);
    add_help(program);
    add_hidden_commands(program, [](std::string_view) { return std::vector<Completions::Word>(); });
}

}  // namespace

// What goes wrong while an error is told ends in the handler that `guarded` sets.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    Commands commands;
    return run_program({argv, static_cast<std::size_t>(argc)}, "Gates on what Monte Carlo codes report.",
                       [&](ProgramDefinition& program) { add_commands(program, commands); });
}

#include "app/command_line/program.hpp"

#include "app/command_line/parser.hpp"
#include "app/process/guard.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace ff::app {
namespace {

ExitCode parse_and_act(const ProgramDefinition& program, std::span<char* const> arguments) {
    const ParsedCommandLine parsed = parse(program, arguments, width_of(STDOUT_FILENO));
    if (parsed.command != nullptr) return parsed.command->action();
    print_folded(parsed.text);
    return ExitCode::passed;
}

}  // namespace

void add_verbosity(CommandDefinition& command, bool& quiet, const std::string& quiet_prints) {
    command.option("-q,--quiet", quiet, quiet_prints);
    command.option("-v,--verbose", be_verbose, "Also print what is planned and which files are written");
}

void add_help(ProgramDefinition& program) {
    const auto [command, name] = program.command<std::string>(
        everyday, "help", "Show this help, or that of a command", [&program](const std::string& asked) {
            print_folded(help_of(program, asked, width_of(STDOUT_FILENO)));
            return ExitCode::passed;
        });
    command.option("COMMAND", name, "A command");
}

int run_program(std::span<char*> arguments, const std::string& summary,
                const std::function<void(ProgramDefinition& program)>& add) {
    receive_signals();
    turn_output_signals_into_errors();
    const ExitCode code = guarded(arguments, [&] {
        ProgramDefinition program;
        program.summary = summary;
        program.version = fmt::format("ffstudy {} ({})", build_info::version, build_info::revision);
        program.footer =
            "Exit codes: 0 passed, 1 out of tolerance or a contradiction, 2 usage or input, 3 input/output, 4 "
            "inconclusive or a faulty scene, 130 interrupted (what was done is saved).";
        add(program);
        return parse_and_act(program, arguments);
    });
    close_to_signals();
    return static_cast<int>(code);
}

}  // namespace ff::app

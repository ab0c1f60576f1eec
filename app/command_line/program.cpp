#include "app/command_line/program.hpp"

#include "app/command_line/parser.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "studies/readers/printable.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

namespace ff::app {
namespace {

std::span<char* const> arguments_of_program;

/// The command line, so that an error from deep inside names its inputs.
std::string asked() {
    std::string text = "ffstudy";
    for (std::size_t i = 1; i < arguments_of_program.size(); ++i) text += fmt::format(" {}", arguments_of_program[i]);
    return text;
}

ExitCode fail(ExitCode code, const std::string& message) {
    say("ffstudy: {}\n", message);
    return code;
}

ExitCode fail_unexpectedly(std::string_view what) {
    return fail(ExitCode::usage,
                fmt::format("'{}': {} (no input should lead to this error). Please report it, with the "
                            "files that are named here.",
                            asked(), what));
}

/// Reports the exception that is being handled.
ExitCode tell_exception() {
    try {
        throw;
    } catch (const UserError& error) {
        return fail(ExitCode::usage, error.what());
    } catch (const IoError& error) {
        return fail(ExitCode::io, error.what());
    } catch (const InterruptedError& error) {
        return fail(ExitCode::interrupted, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(ExitCode::io, fmt::format("{}. Check the path, the permissions and the free space.", error.what()));
    } catch (const std::system_error& error) {
        return fail(ExitCode::io, fmt::format("{}. Check the disk, or the pipe that reads the output.", error.what()));
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::usage,
                    fmt::format("'{}': out of memory. Take fewer patches, faces or threads.", asked()));
    } catch (const std::exception& error) {
        return fail_unexpectedly(error.what());
    } catch (...) {
        return fail_unexpectedly("an exception of unknown kind");
    }
}

[[noreturn]] void end_uncaught() {
    const bool thrown = std::current_exception() != nullptr;
    std::_Exit(static_cast<int>(thrown ? tell_exception() : fail_unexpectedly("the program was terminated")));
}

/// Reports hold names of files, and JSON and SQLite hold text.
void expect_utf8() {
    for (const std::string_view argument : arguments_of_program) {
        if (studies::find_no_utf8(argument) == std::string_view::npos) continue;
        throw UserError("{}: not UTF-8 (reports could not hold it). Rename the file, or choose another name.",
                        argument);
    }
}

/// Runs an action, and turns any exception into a message with the input that caused it, and a documented exit code.
/// Exceptions that nobody can catch, from a destructor or a library's thread, are reported too and end the process.
/// @param arguments  of the program, its name first; they live as long as it does
ExitCode guarded(std::span<char* const> arguments, const std::function<ExitCode()>& act) {
    arguments_of_program = arguments;
    std::set_terminate(end_uncaught);
    try {
        expect_utf8();
        const ExitCode code = act();
        if (!flush_output())
            return fail(ExitCode::io, "standard output cannot be written. Check the disk or the pipe.");
        return code;
    } catch (...) {
        return tell_exception();
    }
}

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

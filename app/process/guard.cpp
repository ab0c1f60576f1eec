#include "app/process/guard.hpp"

#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
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
        throw UserError(fmt::format(
            "{}: not UTF-8 (reports could not hold it). Rename the file, or choose another name.", argument));
    }
}

}  // namespace

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

}  // namespace ff::app

#include "app/command_line/program.hpp"

#include "app/command_line/command_model.hpp"
#include "app/command_line/usage_errors.hpp"
#include "app/process/guard.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/messages.hpp"
#include "app/terminal/terminal_style.hpp"

#include "core/support/error.hpp"

#include "app/build_info.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <sstream>
#include <utility>

namespace ff::app {
namespace {

using AddCommands = std::function<void(CLI::App&, Action&)>;

ExitCode parse_and_act(std::span<char*> arguments, const std::string& summary, const AddCommands& add) {
    CLI::App app(summary, "ffstudy");
    app.set_version_flag("-V,--version", fmt::format("ffstudy {} ({})", build_info::version, build_info::revision));
    app.require_subcommand(0, 1);  // an unknown option is named first; that a command is missing, below
    app.footer(
        "Exit codes: 0 passed, 1 out of tolerance or a contradiction, 2 usage or input, 3 input/output, 4 "
        "inconclusive, 130 interrupted (what was done is saved).");
    Action action;
    add(app, action);
    name_types_of_arguments(app);
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("Positionals", "Arguments");
    app.get_formatter()->label("REQUIRED", "");
    try {
        app.parse(static_cast<int>(arguments.size()), arguments.data());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw UserError(usage_problem(app, error));
        std::ostringstream text;
        fit_descriptions(app, width_of(STDOUT_FILENO));
        app.exit(error, text);  // --help, --version
        fmt::print("{}", text.str());
        return ExitCode::passed;
    }
    refuse_unmeant_values(app);
    if (action) return action();
    fit_descriptions(app, width_of(STDOUT_FILENO));
    fmt::print("{}", app.help());
    return ExitCode::passed;
}

}  // namespace

CLI::App* add_command(CLI::App& app, const char* group, std::string name, std::string summary) {
    return app.add_subcommand(std::move(name), std::move(summary))->group(group);
}

void add_verbosity(CLI::App& command, bool& quiet, const std::string& quiet_prints) {
    command.add_flag("-q,--quiet", quiet, quiet_prints);
    command.add_flag_callback("-v,--verbose", be_verbose, "Also print what is planned and which files are written");
}

void add_help(CLI::App& app, Action& action) {
    CLI::App* sub = add_command(app, everyday, "help", "Show this help, or that of a command");
    const CLI::Option* name = sub->add_option("COMMAND", "A command");
    sub->callback([&app, &action, name] {
        action = [&app, name] {
            fit_descriptions(app, width_of(STDOUT_FILENO));
            fmt::print("{}", help_of_command(app, name->count() > 0 ? name->as<std::string>() : std::string()));
            return ExitCode::passed;
        };
    });
}

int run_program(std::span<char*> arguments, const std::string& summary, const AddCommands& add) {
    receive_signals();
    turn_output_signals_into_errors();
    const ExitCode code = guarded(arguments, [&] { return parse_and_act(arguments, summary, add); });
    close_to_signals();
    return static_cast<int>(code);
}

}  // namespace ff::app

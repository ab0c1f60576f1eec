#include "app/commands/gates/gate_commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/context/program_context.hpp"
#include "app/commands/gates/check_estimates.hpp"
#include "app/commands/gates/check_session.hpp"
#include "app/commands/gates/save_means.hpp"

#include "reports/terminal/gates_terminal.hpp"
#include "studies/verdicts/bands_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::app {

CommandDefinition& add_check_of_files(ProgramDefinition& program, CheckCommand& command) {
    CommandDefinition& sub =
        program.command(checks, "check", "Check the gates of a bands file: pass, fail or inconclusive");
    sub.option("BANDS", command.bands, "Bands file (.toml)", {.is_required = true});
    sub.option(
        "--estimates", command.estimates,
        "CSV of another program: trial,quantity,estimate, or quantity,mean,standard_error, or quantity,bin,count",
        {.type = "FILE"});
    sub.option("--against", command.against, "Second CSV, to compare with", {.type = "FILE"});
    sub.option("--again", command.again, "Look at this commit, perhaps again: looks share alpha", {.type = "COMMIT"});
    sub.option("--ledger", command.ledger, "File of the looks at commits (default: <bands>.ledger.csv)",
               {.type = "FILE", .needs = {"--again"}});
    sub.option("--save-baseline", command.save_baseline, "Save what others are compared with; judge nothing",
               {.type = "FILE"});
    sub.option("--out", command.out, "Folder for the results (default: results/<bands>)", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
    sub.option("--dry-run", command.dry_run, "Show trials and expected time of each gate; runs pilots only");
    sub.option("--json", command.json, "Print the verdicts as JSON, as in verdicts.json",
               {.excludes = {"--again", "--dry-run", "--save-baseline"}});
    return sub;
}

ExitCode check_files(const CheckCommand& command) {
    auto spec = studies::gates::load_bands(command.bands, nullptr);
    expect_estimates(command, spec);
    if (!command.save_baseline.empty()) {
        save_means(command);
        return ExitCode::passed;
    }
    if (command.dry_run) {
        fmt::print("{}", reports::estimates_plan(spec, plan_file(command, spec)));
        return ExitCode::passed;
    }
    auto context = describe_program(fmt::format("ffstudy check {}", command.bands.string()), 1, 0);
    return judge({command, std::move(spec), std::move(context), nullptr});
}

}  // namespace ff::app

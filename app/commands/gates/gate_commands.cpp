#include "app/commands/gates/gate_commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/context/program_context.hpp"
#include "app/commands/gates/check_estimates.hpp"
#include "app/commands/gates/check_session.hpp"
#include "app/folders/output_folder.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/files/output_file.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "stats/basics/moments.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "studies/verdicts/reported/estimates_file.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace ff::app {
namespace {

/// Judges a bands file with gates on files only.
ExitCode judge_files_only(const CheckCommand& command) {
    auto spec = studies::gates::load_bands(command.bands, nullptr);
    expect_estimates(command, spec);
    if (!command.save_baseline.empty()) {
        save_means(command);
        return ExitCode::passed;
    }
    if (command.dry_run) {
        print_folded(reports::estimates_plan(spec, plan_file(command, spec)));
        return ExitCode::passed;
    }
    auto context = describe_program(fmt::format("ffstudy check {}", command.bands.string()), 1, 0);
    return judge({command, std::move(spec), std::move(context), nullptr});
}

}  // namespace

void add_options_of_files(CommandDefinition& sub, CheckCommand& command) {
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
}

void add_check_of_files(ProgramDefinition& program) {
    const auto [sub, command] = program.command<CheckCommand>(checks, "check", check_summary, judge_files_only);
    add_options_of_files(sub, command);
}

void save_means(const CheckCommand& command) {
    const auto text = studies::read_text_file(command.estimates, studies::FileKind::estimates);
    const std::string origin = command.estimates.string();
    std::string means = text;
    if (studies::gates::reports_means(text)) {
        static_cast<void>(studies::gates::parse_reported(text, origin, studies::gates::StandardErrors::optional));
    } else {
        means = "quantity,mean,standard_error,n\n";
        const auto file = studies::gates::parse_estimates(text, origin);
        for (const studies::gates::EstimateSeries& series : file.series) {
            const double first = series.values.front();
            const auto moments = stats::moments_of(series.values, first);
            const double error = *moments.standard_error();
            if (error == 0)
                throw UserError(
                    fmt::format("{}: all values of '{}' are equal (no spread is no evidence of precision). "
                                "Was every trial seeded alike?",
                                origin, series.quantity));
            means += fmt::format("{},{},{},{}\n", reports::csv_field(series.quantity), first + *moments.bias(), error,
                                 series.values.size());
        }
    }
    const OutputFolder lock(reports::folder_of(command.save_baseline), "baseline");
    reports::write_file(command.save_baseline, means);
    if (!command.quiet) print_folded("Baseline: {} (compare with it by --against)\n", command.save_baseline.string());
}

}  // namespace ff::app

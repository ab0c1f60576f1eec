#include "app/commands/gate_commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/check_estimates.hpp"
#include "app/commands/check_session.hpp"
#include "app/commands/history_command.hpp"
#include "app/commands/program_context.hpp"

#include "reports/terminal/gates_terminal.hpp"
#include "studies/verdicts/bands_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::app {

CLI::App* add_check_of_files(CLI::App& app, CheckCommand& command) {
    CLI::App* sub = add_command(app, checks, "check", "Check the gates of a bands file: pass, fail or inconclusive");
    sub->add_option("BANDS", command.bands, "Bands file (.toml)")->required();
    sub->add_option(
           "--estimates", command.estimates,
           "CSV of another program: trial,quantity,estimate, or quantity,mean,standard_error, or quantity,bin,count")
        ->type_name("FILE");
    sub->add_option("--against", command.against, "Second CSV, to compare with")->type_name("FILE");
    CLI::Option* again =
        sub->add_option("--again", command.again, "Look at this commit, perhaps again: looks share alpha")
            ->type_name("COMMIT");
    sub->add_option("--ledger", command.ledger, "File of the looks at commits (default: <bands>.ledger.csv)")
        ->type_name("FILE")
        ->needs(again);
    sub->add_option("--history", command.history, "File that a line for each quantity is added to; see 'ffstudy trend'")
        ->type_name("FILE");
    sub->add_option("--commit", command.commit, "Name of this run in the history")->type_name("COMMIT");
    sub->add_option("--save-baseline", command.save_baseline, "Save what others are compared with; judge nothing")
        ->type_name("FILE");
    sub->add_option("--out", command.out, "Folder for the results (default: results/<bands>)")->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    CLI::Option* dry_run =
        sub->add_flag("--dry-run", command.dry_run, "Show trials and expected time of each gate; runs pilots only");
    sub->add_flag("--json", command.json, "Print the verdicts as JSON, as in verdicts.json")
        ->excludes(again, dry_run, sub->get_option("--save-baseline"));
    return sub;
}

void add_trend(CLI::App& app, TrendCommand& command, Action& action) {
    CLI::App* sub = add_command(app, checks, "trend", "Find changes of means, spreads and costs over commits");
    sub->add_option("HISTORY", command.history, "File that 'check --history' has filled")->required();
    sub->add_option("--alpha", command.alpha, "Chance of finding a change anywhere where there is none")
        ->capture_default_str();
    sub->add_option("--seed", command.seed, "Seed of the permutations")->capture_default_str();
    sub->add_option("--out", command.out, "Folder for trend.html (default: none is written)")->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return trend(command); }; });
}

ExitCode check_files(const CheckCommand& command) {
    auto spec = studies::load_bands(command.bands, nullptr);
    expect_estimates(command, spec);
    expect_history(command);
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

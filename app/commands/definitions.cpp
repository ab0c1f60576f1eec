#include "app/commands/definitions.hpp"

#include "app/command_line/listings.hpp"
#include "app/commands/commands.hpp"
#include "app/folders/result_files.hpp"

#include "studies/selftest/selftest.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::app {

void add_report(CLI::App& app, ReportCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "report", "Write the reports of a finished study again");
    sub->add_option("RESULTS", command.results, "Folder of a study, or its results.sqlite")->required();
    sub->add_option("--format", command.formats,
                    fmt::format("{} (default: {})", names_in_words("formats"), fmt::join(usual_formats(), ", ")))
        ->type_name("FORMAT")
        ->delimiter(',');
    sub->add_option("--pictures", command.pictures,
                    "Pictures for svg and pdf: names as 'ffstudy figure' lists them, or how they begin (default: all)")
        ->type_name("PICTURE")
        ->delimiter(',');
    sub->add_option("--out", command.out, "Folder for the files (default: where the results lie)")->type_name("DIR");
    sub->add_option("--templates", command.templates, "Folder of custom templates for report.html")->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return report(command); }; });
}

void add_compare(CLI::App& app, CompareCommand& command, Action& action) {
    CLI::App* sub =
        add_command(app, everyday, "compare", "Show two runs side by side: what differs, and how sure that is");
    sub->add_option("A", command.first, "Folder of a study, or its results.sqlite; of one method: RESULTS:METHOD")
        ->type_name("RESULTS")
        ->required();
    sub->add_option("B", command.second, "The other")->type_name("RESULTS")->required();
    sub->add_option("--out", command.out, "Folder for comparison.md and comparison.html (default: none is written)")
        ->type_name("DIR");
    sub->add_option("--templates", command.templates, "Folder of custom templates for comparison.html")
        ->type_name("DIR");
    sub->add_flag("--json", command.json, "Print JSON");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return compare(command); }; });
}

void add_merge(CLI::App& app, MergeCommand& command, Action& action) {
    CLI::App* sub = add_command(app, laboratory, "merge", "Bring the results of shards together");
    sub->add_option("RESULTS", command.sources, "Folders of the shards, or their results.sqlite")->required();
    sub->add_option("--out", command.out, "Folder for the merged results")->type_name("DIR")->required();
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return merge(command); }; });
}

void add_audit(CLI::App& app, AuditCommand& command, Action& action) {
    CLI::App* sub = add_command(app, laboratory, "audit", "Find contradictions in published tables");
    sub->add_option("TABLES", command.tables, "Tables file (.json)")->required();
    sub->add_option("--out", command.out, "Folder for audit.md (default: none is written)")->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return audit(command); }; });
}

void add_check(CLI::App& app, CheckCommand& command, OutsideOptions& outside, Action& action) {
    CLI::App* sub = add_check_of_files(app, command);
    CLI::Option* seed = sub->add_option("--seed", command.seed, "Seed of all random numbers (default: the file's)")
                            ->check(CLI::NonNegativeNumber);
    sub->add_flag("--fresh-seed", command.fresh_seed, "A new seed, printed")->excludes(seed);
    sub->add_option("--seed-sweep", command.seed_sweep, "Check with N seeds; report failure rates against alpha")
        ->check(CLI::PositiveNumber)
        ->excludes(sub->get_option("--json"));
    sub->add_option("--baseline", command.baseline, "Baseline file to compare with")
        ->type_name("FILE")
        ->excludes(sub->get_option("--save-baseline"));
    add_outside_options(*sub, outside, OutsideCodeFrom::files_too);
    sub->add_option("--threads", command.threads, "Threads; verdicts do not depend on them (default: all cores)");
    sub->callback([&] { action = [&] { return check(command, outside); }; });
}

void add_selftest(CLI::App& app, SelftestCommand& command, Action& action) {
    constexpr auto& description = studies::selftest_description;
    CLI::App* sub = add_command(app, checks, std::string(description.name), std::string(description.summary));
    sub->add_option("--seeds", command.seeds, "Seeds that every control is run with (default: 200)")
        ->check(CLI::PositiveNumber);
    sub->add_option("--repetitions", command.repetitions, "Repetitions on made-up trials (default: 20000)")
        ->check(CLI::PositiveNumber);
    sub->add_option("--seed", command.seed, "Seed of all random numbers (default: 1)")->check(CLI::NonNegativeNumber);
    sub->add_option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    sub->add_option("--out", command.out, "Folder for selftest.md (default: none is written)")->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return gates_selftest(command); }; });
}

namespace {

void add_coverage_options(CLI::App& sub, SelftestCommand& command) {
    sub.add_option("--seeds", command.seeds, "Seeds that every scene is computed with (default: 200)")
        ->check(CLI::PositiveNumber);
    sub.add_option("--tolerance", command.tolerance, "Of the form factors (default: 0.004)")
        ->check(CLI::PositiveNumber);
    sub.add_option("--scene", command.scenes, "Scenes, separated by commas (default: the catalogue)")
        ->type_name("SCENE")
        ->delimiter(',');
    sub.add_option("--seed", command.seed, "The first seed (default: 1)")->check(CLI::NonNegativeNumber);
    sub.add_option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    sub.add_option("--out", command.out, "Folder for selftest.md (default: none is written)")->type_name("DIR");
    add_verbosity(sub, command.quiet);
}

}  // namespace

void add_form_factors_selftest(CLI::App& app, SelftestCommand& command, Action& action) {
    CLI::App* sub = add_command(app, checks, "form_factors_selftest",
                                "How often the intervals of 'form_factors' hold the values of the catalogue");
    add_coverage_options(*sub, command);
    sub->callback([&] { action = [&] { return form_factors_selftest(command); }; });
}

void add_heat_selftest(CLI::App& app, SelftestCommand& command, Action& action) {
    CLI::App* sub = add_command(app, checks, "heat_selftest",
                                "How often the limits of 'heat' hold flows of the catalogue's scenes");
    add_coverage_options(*sub, command);
    sub->callback([&] { action = [&] { return heat_selftest(command); }; });
}

void add_list(CLI::App& app, ListCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "list", "List samplers, estimators, scenes, studies and so on");
    sub->add_option("KIND", command.name, listed_kinds_in_words());
    sub->add_flag("--json", command.json, "Print JSON");
    add_outside_options(*sub, command.outside, OutsideCodeFrom::plugins);
    sub->callback([&] { action = [&] { return list(command); }; });
}

void add_explain(CLI::App& app, ListCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "explain", "Say what something is, its source, its limits");
    sub->add_option("NAME", command.name, "A name that 'list' shows, or a scene file");
    sub->add_flag("--json", command.json, "Print JSON");
    add_outside_options(*sub, command.outside, OutsideCodeFrom::plugins);
    sub->callback([&] { action = [&] { return explain(command); }; });
}

void add_points(CLI::App& app, PointsCommand& command, Action& action) {
    CLI::App* sub = add_command(app, laboratory, "points", "Write a point set, or say how evenly it is spread");
    sub->add_option("SAMPLER", command.sampler, "A sampler, file:PATH or command:PROGRAM")->required();
    sub->add_option("--n", command.points, "Points")->capture_default_str();
    sub->add_option("--d", command.dimension, "Coordinates of a point")->capture_default_str();
    sub->add_option("--seed", command.seed, "Seed of all random numbers")->capture_default_str();
    sub->add_option("--trial", command.trial, "Which of the trials, from 0")->capture_default_str();
    add_outside_options(*sub, command.outside, OutsideCodeFrom::command_line);
    sub->add_option("--out", command.out, "File: .npy, .csv, .dat or .svg (default: none is written)")
        ->type_name("FILE");
    sub->callback([&] { action = [&] { return points(command); }; });
}

void add_check_sampler(CLI::App& app, CheckSamplerCommand& command, Action& action) {
    CLI::App* sub =
        add_command(app, checks, "check-sampler", "Check what any sampler has to keep: pass, fail, inconclusive");
    sub->add_option("SAMPLER", command.sampler, "A sampler, file:PATH#RANDOMISE or command:PROGRAM")->required();
    sub->add_option("--n", command.points, "Points (default: about 256, or those of the largest file)");
    sub->add_option("--d", command.dimension, "Coordinates of a point (default: all, at most 4)");
    sub->add_option("--trials", command.trials, "Trials (default: about a second's)")->check(CLI::PositiveNumber);
    sub->add_option("--seed", command.seed, "Seed of all random numbers")->capture_default_str();
    add_outside_options(*sub, command.outside, OutsideCodeFrom::command_line);
    sub->callback([&] { action = [&] { return check_sampler(command); }; });
}

}  // namespace ff::app

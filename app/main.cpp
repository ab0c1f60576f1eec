#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/definitions.hpp"
#include "app/commands/figure_command.hpp"
#include "app/commands/hidden_commands.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/study_files.hpp"

#include "reports/programs/hand_over.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace ff::app;

void add_run_options(CLI::App& app, RunCommand& command) {
    app.add_option("--trials", command.trials, "Repetitions of every sampled size (default: the study's)");
    app.add_option("--seed", command.seed, "Seed of all random numbers (default: the study's)");
    app.add_option("--until", command.until, "Stop at a goal: rmse=1e-5 or ci=1e-5; --trials is then the most")
        ->type_name("GOAL");
    app.add_option("--level", command.level, "Level of intervals (default: the study's)");
    app.add_option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    app.add_option("--shard", command.shard, "Carry out share i/n of the work only; see 'ffstudy merge'")
        ->type_name("I/N");
    app.add_option("--max-time", command.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully")
        ->type_name("TIME");
    app.add_option("--max-memory", command.max_memory, "Memory limit: 500M, 2G; fewer threads, or a graceful stop")
        ->type_name("SIZE");
    app.add_option("--out", command.out, "Folder for the results (default: results/<study>)")->type_name("DIR");
    app.add_option("--templates", command.templates, "Folder of custom templates for report.html")->type_name("DIR");
    app.add_flag("--replace", command.replace, "Replace another study in the folder; its store is kept aside");
    add_outside_options(app, command.outside, OutsideCodeFrom::files_too);
    add_verbosity(app, command.quiet);
    app.add_flag("--dry-run", command.dry_run, "Show work units, expected time and memory, run nothing");
}

void add_run(CLI::App& app, RunCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "run", "Run or resume a study");
    sub->add_option("STUDY", command.study, "Study file (.toml), built-in name, or folder of a study to resume")
        ->required();
    add_run_options(*sub, command);
    sub->callback([&] { action = [&] { return run(command); }; });
}

void add_built_in_studies(CLI::App& app, RunCommand& command, Action& action) {
    for (const BuiltInStudy& study : built_in_studies()) {
        CLI::App* alias = add_command(app, built_in, study.name, study.title);
        add_run_options(*alias, command);
        alias->callback([&command, &action, name = study.name] {
            command.study = name;
            action = [&command] { return run(command); };
        });
    }
}

void add_convergence(CLI::App& app, ff::studies::ConvergenceRequest& request, RunCommand& command, Action& action) {
    CLI::App* sub =
        add_command(app, laboratory, "convergence", "Run samplers on a ladder of sizes and fit how fast they converge");
    sub->add_option("--sampler", request.samplers, "Samplers, separated by commas")
        ->type_name("SAMPLER")
        ->delimiter(',')
        ->required();
    sub->add_option("--estimator", request.estimator, "Estimator: " + names_in_words("estimators"))
        ->type_name("ESTIMATOR")
        ->capture_default_str();
    sub->add_option("--scene", request.scenes, "Scenes, separated by commas")
        ->type_name("SCENE")
        ->delimiter(',')
        ->capture_default_str();
    sub->add_option("--samples", request.samples, "Sizes: a range, or numbers separated by commas")
        ->type_name("SIZES")
        ->capture_default_str();
    sub->add_option("--patches", request.patches_per_face, "Patches of a face")->capture_default_str();
    sub->add_option("--allocation", request.allocation, "Whose points they are: " + names_in_words("allocations"))
        ->type_name("ALLOCATION");
    sub->add_option("--completion", request.completion, "How the matrix is completed: " + names_in_words("completions"))
        ->type_name("COMPLETION");
    sub->add_option("--map", request.map, "How points are laid on patches: " + names_in_words("maps"))
        ->type_name("MAP");
    sub->add_option("--save-study", command.study_file, "Write the study file, to run or change it later")
        ->type_name("FILE");
    add_run_options(*sub, command);
    sub->callback([&] {
        action = [&] {
            command.convergence = request;
            return run(command);
        };
    });
}

void add_radiosity(CLI::App& app, RadiosityOptions& options, RunCommand& command, Action& action) {
    CLI::App* sub = add_command(app, laboratory, "radiosity", "Run a study and send light through its form factors");
    sub->add_option("STUDY", command.study, "Study file (.toml), built-in name, or folder of a study to resume")
        ->required();
    sub->add_option("--reflectance", options.reflectance,
                    "Reflectances, each solved for separately (default: the study's, or 0.1,0.5,0.9,0.99,0.999)")
        ->type_name("LIST");
    sub->add_option("--emission", options.emission,
                    "Emitted exitance, one number or one for each face (default: the study's, or 1 on the last face)")
        ->type_name("LIST");
    sub->add_option("--patch-trials", options.patch_trials,
                    "Trials that are solved between patches too (default: the study's, or 0)");
    add_run_options(*sub, command);
    sub->callback([&] {
        action = [&] {
            command.radiosity = options;
            return run(command);
        };
    });
}

void add_enclosure(CLI::App& app, EnclosureCommand& command, Action& action) {
    CLI::App* sub =
        add_command(app, laboratory, "enclosure", "Light where surfaces see themselves: round rooms, mirrors");
    sub->add_option("SHAPE", command.name, "cylinder:RxH, cap:RxH, cone:RxH, spheres:RxS, or cube, box:AxBxC")
        ->required();
    sub->add_option("--mirror", command.mirror, "The face of a box that is a perfect mirror")->type_name("FACE");
    sub->add_option("--reflectance", command.light.reflectance,
                    "Reflectances, each solved for separately (default: 0.1,0.5,0.9,0.99,0.999)")
        ->type_name("LIST");
    sub->add_option("--emission", command.light.emission,
                    "Emitted exitance, one number or one for each surface (default: 1 on the last)")
        ->type_name("LIST");
    sub->add_option("--trials", command.trials, "Trials of rays drawn from the exact factors (default: 0)");
    sub->add_option("--rays", command.rays, "Rays from each surface in a trial")->capture_default_str();
    sub->add_option("--seed", command.seed, "Seed of all random numbers")->capture_default_str();
    sub->add_option("--out", command.out, "Folder for enclosure.md and the matrices (default: none is written)")
        ->type_name("DIR");
    add_verbosity(*sub, command.quiet);
    sub->callback([&] { action = [&] { return enclosure(command); }; });
}

/// What an OBJ file or a mesh does not say itself.
std::vector<CLI::Option*> add_options_of_meshes(CLI::App& app, FormFactorsCommand& command) {
    CLI::Option* faces =
        app.add_option("--faces", command.faces, "What a face of an OBJ file or a mesh is: group, polygon or material");
    faces->type_name("FACES")->check(CLI::IsMember({"group", "polygon", "material"}))->capture_default_str();
    return {faces,
            app.add_flag("--closed", command.closed, "An OBJ file or a mesh is closed: every ray hits something")};
}

void add_form_factors(CLI::App& app, FormFactorsCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "form_factors", "All form factors of a scene, each with an interval");
    auto& request = command.request;
    CLI::Option* load =
        sub->add_option("--load", command.load, "Instead of SCENE: a folder that --out has written")->type_name("DIR");
    const auto of_a_run = [load](CLI::Option* option) { return option->excludes(load); };
    of_a_run(sub->add_option("SCENE", command.scene,
                             fmt::format("cube, box:AxBxC, another built-in scene, or a file ({})",
                                         ff::studies::scene_extensions_in_words())));
    for (CLI::Option* option : add_options_of_meshes(*sub, command)) of_a_run(option);
    of_a_run(sub->add_option("--tolerance", request.tolerance, "Largest half width of an interval"))
        ->capture_default_str();
    of_a_run(sub->add_option("--relative", request.relative,
                             "Or this share of the factor, where that is more: 0.01 for 1 %"));
    CLI::Option* drop = sub->add_option("--drop", request.drop, "Keep only sums of pairs with factors below this");
    of_a_run(drop);
    of_a_run(sub->add_option("--level", request.level, "Level of the intervals"))->capture_default_str();
    of_a_run(
        sub->add_flag("--simultaneous", command.whole_matrix, "The level is that of all entries and row sums at once"));
    of_a_run(sub->add_option("--seed", command.seed, "Seed of all random numbers"))->capture_default_str();
    of_a_run(
        sub->add_option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)"));
    of_a_run(
        sub->add_option("--max-time", command.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully")
            ->type_name("TIME"));
    of_a_run(sub->add_option("--max-memory", command.max_memory, "Memory limit: 500M, 2G; stops gracefully")
                 ->type_name("SIZE"));
    of_a_run(sub->add_option("--max-samples", request.max_samples, "Rays and points in all"))->capture_default_str();
    CLI::Option* shard = sub->add_option("--shard", command.shard, "Sample share i/n of the rows; see 'ffstudy merge'");
    of_a_run(shard->type_name("I/N"));
    of_a_run(sub->add_flag("--dry-run", command.dry_run, "Sample a few rows, show expected time, memory and disk"));
    sub->add_flag("--repair", request.repair, "Also the nearest matrix that is closed and reciprocal")->excludes(drop);
    CLI::Option* out = sub->add_option("--out", command.out, "Folder for the matrices (default: none is written)");
    out->type_name("DIR");
    shard->needs(out);
    sub->add_option("--format", command.formats,
                    fmt::format("Also files for other programs: {}", ff::reports::program_formats_in_words()))
        ->type_name("PROGRAMS")
        ->delimiter(',')
        ->needs(out)
        ->excludes(drop);
    add_verbosity(*sub, command.quiet, "Print errors and warnings only");
    sub->callback([&] { action = [&] { return form_factors(command); }; });
}

void add_heat(CLI::App& app, HeatCommand& command, Action& action) {
    CLI::App* sub = add_command(app, everyday, "heat", "Heat or light between the faces of a scene, with intervals");
    auto& factors = command.factors;
    factors.whole_matrix = true;
    CLI::Option* load = sub->add_option("--load", factors.load,
                                        "Instead of SCENE: a folder that 'form_factors --simultaneous' has written");
    load->type_name("DIR");
    const auto of_a_run = [load](CLI::Option* option) { return option->excludes(load); };
    of_a_run(
        sub->add_option("SCENE", factors.scene,
                        fmt::format("A built-in scene, or a file ({})", ff::studies::scene_extensions_in_words())));
    for (CLI::Option* option : add_options_of_meshes(*sub, factors)) of_a_run(option);
    sub->add_option("--materials", command.materials, "Materials file (.toml): emissivities and temperatures or fluxes")
        ->type_name("FILE")
        ->required();
    sub->add_option("--scale", command.scale, "Metres of a unit of length of the scene")->capture_default_str();
    sub->add_option("--flow-tolerance", command.flow_tolerance,
                    "Of every power: 0.1% of what the sources give off (default), or 40W")
        ->type_name("AMOUNT");
    of_a_run(sub->add_option("--tolerance", command.tolerance,
                             "Largest half width of a form factor (default: 1e-4), or of a power (default: 0.1%)"))
        ->type_name("AMOUNT");
    of_a_run(sub->add_option("--tolerance-of", command.tolerance_of,
                             "What --tolerance is of: factor, or flux, which samples where powers depend on it"))
        ->type_name("WHAT")
        ->check(CLI::IsMember({"factor", "flux"}))
        ->capture_default_str();
    of_a_run(sub->add_option("--level", factors.request.level, "Level of all intervals at once"))
        ->capture_default_str();
    of_a_run(sub->add_option("--seed", factors.seed, "Seed of all random numbers"))->capture_default_str();
    of_a_run(
        sub->add_option("--threads", factors.threads, "Threads; results do not depend on them (default: all cores)"));
    of_a_run(
        sub->add_option("--max-time", factors.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully")
            ->type_name("TIME"));
    of_a_run(sub->add_option("--max-samples", factors.request.max_samples, "Rays and points in all"))
        ->capture_default_str();
    CLI::Option* out = sub->add_option("--out", factors.out, "Folder for heat.csv (default: none is written)");
    out->type_name("DIR");
    sub->add_flag("--gebhart", command.gebhart, "Also Gebhart factors and script-F, in gebhart.csv")->needs(out);
    add_verbosity(*sub, factors.quiet, "Print errors and warnings only");
    sub->callback([&] { action = [&] { return heat(command); }; });
}

/// What all commands fill in; they are called after everything is parsed.
struct Commands {
    RunCommand run_command;
    ReportCommand report_command;
    FigureCommand figure_command;
    MergeCommand merge_command;
    CompareCommand compare_command;
    AuditCommand audit_command;
    CheckCommand check_command;
    OutsideOptions check_outside;
    TrendCommand trend_command;
    SelftestCommand selftest_command;
    ff::studies::ConvergenceRequest convergence_request;
    RadiosityOptions radiosity_options;
    EnclosureCommand enclosure_command;
    FormFactorsCommand form_factors_command;
    PointsCommand points_command;
    CheckSamplerCommand check_sampler_command;
    HeatCommand heat_command;
    ListCommand list_command;
};

std::vector<Completions::Word> words_of_type(std::string_view type) {
    std::vector<Completions::Word> words;
    for (auto& [name, summary] : listed_for_type(type)) words.push_back({std::move(name), std::move(summary)});
    return words;
}

void add_commands(CLI::App& app, Commands& all, Action& action) {
    add_form_factors(app, all.form_factors_command, action);
    add_heat(app, all.heat_command, action);
    add_run(app, all.run_command, action);
    add_report(app, all.report_command, action);
    add_figure(app, all.figure_command, action);
    add_compare(app, all.compare_command, action);
    add_list(app, all.list_command, action);
    add_explain(app, all.list_command, action);
    add_help(app, action);
    add_convergence(app, all.convergence_request, all.run_command, action);
    add_radiosity(app, all.radiosity_options, all.run_command, action);
    add_enclosure(app, all.enclosure_command, action);
    add_merge(app, all.merge_command, action);
    add_audit(app, all.audit_command, action);
    add_check(app, all.check_command, all.check_outside, action);
    add_trend(app, all.trend_command, action);
    add_selftest(app, all.selftest_command, action);
    add_form_factors_selftest(app, all.selftest_command, action);
    add_heat_selftest(app, all.selftest_command, action);
    add_points(app, all.points_command, action);
    add_check_sampler(app, all.check_sampler_command, action);
    add_built_in_studies(app, all.run_command, action);
    add_hidden_commands(app, words_of_type, action);
}

}  // namespace

// What goes wrong while an error is told ends in the handler that `guarded` sets.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    Commands commands;
    return run_program({argv, static_cast<std::size_t>(argc)}, "Form-factor methods under honest statistics.",
                       [&](CLI::App& app, Action& action) { add_commands(app, commands, action); });
}

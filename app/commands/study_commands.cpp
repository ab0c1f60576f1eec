#include "app/commands/commands.hpp"

#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/run_request.hpp"
#include "app/folders/shipped_files.hpp"

namespace ff::app {
namespace {

void add_run_options(CommandDefinition& sub, RunCommand& command) {
    sub.option("--trials", command.trials, "Repetitions of every sampled size (default: the study's)");
    sub.option("--seed", command.seed, "Seed of all random numbers (default: the study's)");
    sub.option("--until", command.until, "Stop at a goal: rmse=1e-5 or ci=1e-5; --trials is then the most",
               {.type = "GOAL"});
    sub.option("--level", command.level, "Level of intervals (default: the study's)");
    sub.option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    sub.option("--shard", command.shard, "Carry out share i/n of the work only; see 'ffstudy merge'", {.type = "I/N"});
    sub.option("--max-time", command.max_time, "Time limit: 90 (seconds), 15m, 2.5h, 1d; stops gracefully",
               {.type = "TIME"});
    sub.option("--max-memory", command.max_memory, "Memory limit: 500M, 2G; fewer threads, or a graceful stop",
               {.type = "SIZE"});
    sub.option("--out", command.out, "Folder for the results (default: results/<study>)", {.type = "DIR"});
    sub.option("--templates", command.templates, "Folder of custom templates for report.html", {.type = "DIR"});
    sub.option("--replace", command.replace, "Replace another study in the folder; its store is kept aside");
    add_outside_options(sub, command.outside, OutsideCodeFrom::files_too);
    add_verbosity(sub, command.quiet);
    sub.option("--dry-run", command.dry_run, "Show work units, expected time and memory, run nothing");
}

}  // namespace

void add_run(ProgramDefinition& program) {
    const auto [sub, command] = program.command<RunCommand>(everyday, "run", "Run or resume a study", run);
    sub.option("STUDY", command.study, "Study file (.toml), built-in name, or folder of a study to resume",
               {.is_required = true});
    add_run_options(sub, command);
}

void add_built_in_studies(ProgramDefinition& program) {
    for (const BuiltInStudy& study : built_in_studies()) {
        const auto [sub, command] = program.command<RunCommand>(built_in, study.name, study.title, run);
        command.study = study.name;
        add_run_options(sub, command);
    }
}

void add_convergence(ProgramDefinition& program) {
    const auto [sub, command] = program.command<RunCommand>(
        laboratory, "convergence", "Run samplers on a ladder of sizes and fit how fast they converge", run);
    studies::ConvergenceRequest& request = command.convergence.emplace();
    sub.option("--sampler", request.samplers, "Samplers, separated by commas",
               {.type = "SAMPLER", .delimiter = ',', .is_required = true});
    sub.option("--estimator", request.estimator, "Estimator: " + names_in_words("estimators"),
               {.type = "ESTIMATOR", .shows_default = true});
    sub.option("--scene", request.scenes, "Scenes, separated by commas",
               {.type = "SCENE", .delimiter = ',', .shows_default = true});
    sub.option("--samples", request.samples_per_patch, "Sizes: a range, or numbers separated by commas",
               {.type = "SIZES", .shows_default = true});
    sub.option("--patches", request.patches_per_face, "Patches of a face", {.shows_default = true});
    sub.option("--allocation", request.allocation, "Whose points they are: " + names_in_words("allocations"),
               {.type = "ALLOCATION"});
    sub.option("--completion", request.completion, "How the matrix is completed: " + names_in_words("completions"),
               {.type = "COMPLETION"});
    sub.option("--map", request.map, "How points are laid on patches: " + names_in_words("maps"), {.type = "MAP"});
    sub.option("--save-study", command.study_file, "Write the study file, to run or change it later", {.type = "FILE"});
    add_run_options(sub, command);
}

void add_radiosity(ProgramDefinition& program) {
    const auto [sub, command] = program.command<RunCommand>(laboratory, "radiosity",
                                                            "Run a study and send light through its form factors", run);
    RadiosityOptions& options = command.radiosity.emplace();
    sub.option("STUDY", command.study, "Study file (.toml), built-in name, or folder of a study to resume",
               {.is_required = true});
    sub.option("--reflectance", options.reflectance,
               "Reflectances, each solved for separately (default: the study's, or 0.1,0.5,0.9,0.99,0.999)",
               {.type = "LIST"});
    sub.option("--emission", options.emission,
               "Emitted exitance, one number or one for each face (default: the study's, or 1 on the last face)",
               {.type = "LIST"});
    sub.option("--patch-trials", options.patch_trials,
               "Trials that are solved between patches too (default: the study's, or 0)");
    add_run_options(sub, command);
}

}  // namespace ff::app

#include "app/commands/commands.hpp"

#include "app/command_line/listings.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/run_request.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/process/limits.hpp"

#include "core/support/error.hpp"
#include "stats/basics/interval.hpp"
#include "studies/results/resources.hpp"
#include "studies/spec/spec.hpp"
#include "studies/store/store.hpp"

namespace ff::app {
namespace {

studies::StudySpec make_spec(const RunCommand& command, const Processes& processes) {
    if (is_folder_of_study(command.study)) {
        load_plugins(command.outside);
        return studies::Store::open(store_of(command.study)).plan().spec;
    }
    if (!command.convergence) {
        const auto file = find_study(command.study);
        admit_code_of(file, studies::FileKind::study, command.outside,
                      processes.leads() ? Announcement::said : Announcement::silent);
        return studies::load_study(file);
    }
    load_plugins(command.outside);
    for (const std::string& sampler : command.convergence->samplers)
        studies::sampler_of_user(sampler, deadline_of(command.outside));
    return studies::make_convergence_study(*command.convergence);
}

studies::StudyPlan make_plan(const RunCommand& command, const Processes& processes) {
    studies::StudySpec spec = make_spec(command, processes);
    if (command.trials) studies::set_trials(spec, *command.trials);
    if (command.seed) spec.seed = checked_seed(*command.seed);
    if (command.level) {
        if (!stats::is_level(*command.level))
            throw UserError("--level {} (above 0.5, at most 1 - 1e-9). Try 0.95.", *command.level);
        spec.level = *command.level;
    }
    if (command.radiosity) {
        if (!spec.radiosity) spec.radiosity.emplace();
        set_light(*spec.radiosity, *command.radiosity);
    }
    if (command.until) {
        spec.until = studies::parse_stopping_rule(*command.until);
        studies::set_trials(spec, spec.trials);  // bounds the pilot
    }
    return studies::plan_study(std::move(spec));
}

unsigned threads_of(const RunCommand& command, const Processes& processes) {
    return command.threads || processes.alone() ? thread_count(command.threads) : 1;
}

/// The number of these threads that fit into the memory. @throws UserError where not even one does
unsigned threads_within(const studies::StudyPlan& plan, unsigned threads, std::uint64_t memory) {
    while (threads > 1 && studies::expected_memory(plan, threads) > memory) --threads;
    const std::uint64_t least = studies::expected_memory(plan, threads);
    if (least <= memory) return threads;
    throw UserError(
        "--max-memory {}: too little for '{}' (about {} on one thread). Give more, or take fewer trials or "
        "patches.",
        size_in_words(memory), plan.spec.name, size_in_words(least));
}

void add_run_options(CommandDefinition& sub, RunCommand& command) {
    sub.option("--trials", command.trials, "Repetitions of every sampled size (default: the study's)");
    sub.option("--seed", command.seed, "Seed of all random numbers (default: the study's)");
    sub.option("--until", command.until, "Stop at a goal: rmse=1e-5 or ci=1e-5; --trials is then the most",
               {.type = "GOAL"});
    sub.option("--level", command.level, "Level of intervals (default: the study's)");
    sub.option("--threads", command.threads, "Threads; results do not depend on them (default: all cores)");
    sub.option("--shard", command.shard, "Carry out share I/N of the work only; see 'ffstudy merge'", {.type = "I/N"});
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

void set_light(studies::RadiosityRequest& light, const RadiosityOptions& options) {
    if (!options.reflectance.empty()) {
        light.reflectance.clear();
        for (const double value : studies::parse_numbers(options.reflectance, "--reflectance"))
            light.reflectance.push_back({value});
    }
    if (!options.emission.empty()) light.emission = studies::parse_numbers(options.emission, "--emission");
    if (options.patch_trials) light.patch_trials = *options.patch_trials;
    studies::check_radiosity(light, "--");
}

RunRequest check(const RunCommand& command, const Processes& processes) {
    RunRequest request;
    request.plan = make_plan(command, processes);
    request.threads = threads_of(command, processes);
    if (command.shard) request.shard = studies::parse_shard(*command.shard);
    if (request.plan.spec.until && (command.shard || !processes.alone())) {
        throw UserError(
            "an adaptive study cannot be shared (how many trials it needs is decided on all trials of its pilots "
            "together). Leave out --shard and mpirun, or the goal.");
    }
    request.max_time = parse_duration(command.max_time);
    request.max_memory = parse_size(command.max_memory);
    if (request.max_memory) request.threads = threads_within(request.plan, request.threads, *request.max_memory);
    return request;
}

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
    sub.option("--allocation", request.allocation, "What gets points of its own: " + names_in_words("allocations"),
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

#include "app/commands/run_request.hpp"

#include "app/command_line/common_options.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/process/limits.hpp"

#include "core/support/error.hpp"
#include "stats/basics/interval.hpp"
#include "studies/results/resources.hpp"
#include "studies/spec/spec.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

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
            throw UserError(fmt::format("--level {} (above 0.5, at most 1 - 1e-9). Try 0.95.", *command.level));
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
        fmt::format("--max-memory {}: too little for '{}' (about {} on one thread). Give more, or take fewer trials or "
                    "patches.",
                    size_in_words(memory), plan.spec.name, size_in_words(least)));
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
    if (command.max_time) request.max_time = parse_duration(*command.max_time);
    if (command.max_memory) {
        request.max_memory = parse_size(*command.max_memory);
        request.threads = threads_within(request.plan, request.threads, *request.max_memory);
    }
    return request;
}

}  // namespace ff::app

#include "app/commands.hpp"

#include "app/progress.hpp"
#include "app/result_files.hpp"
#include "app/run_context.hpp"
#include "app/signals.hpp"
#include "app/study_files.hpp"

#include "core/error.hpp"
#include "reports/terminal.hpp"
#include "studies/run.hpp"
#include "studies/store.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace ff::app {
namespace {

constexpr std::uint64_t largest_seed = (1ULL << 63) - 1;  // study files hold it as a TOML integer
constexpr unsigned most_threads = 4096;

studies::StudyPlan make_plan(const RunCommand& command) {
    studies::StudySpec spec = find_study(command.study);
    if (command.trials) studies::set_trials(spec, *command.trials);
    if (command.seed) {
        if (*command.seed > largest_seed)
            throw UserError(fmt::format("--seed {} (at most {}). Take a smaller one.", *command.seed, largest_seed));
        spec.seed = Seed{*command.seed};
    }
    return studies::plan_study(std::move(spec));
}

unsigned thread_count(const RunCommand& command) {
    if (!command.threads) return std::max(1u, std::thread::hardware_concurrency());
    if (*command.threads == 0 || *command.threads > most_threads) {
        throw UserError(fmt::format("--threads {} (1 to {} are possible). Leave it out for all cores.",
                                    *command.threads, most_threads));
    }
    return *command.threads;
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw IoError(fmt::format("{}: cannot be made ({}). Choose another --out.", folder.string(), error.message()));
}

/// The command that gives the same results.
std::string reproduce(const studies::StudySpec& spec, const std::string& study,
                      const std::optional<std::uint64_t>& trials) {
    const std::string trial_option = trials ? fmt::format(" --trials {}", *trials) : std::string();
    return fmt::format("ffstudy run {}{} --seed {}", study, trial_option, spec.seed.value);
}

ExitCode describe_plan(const studies::StudyPlan& plan, unsigned threads) {
    fmt::print("{}", reports::terminal_plan(plan, threads));
    return ExitCode::passed;
}

}  // namespace

ExitCode run(const RunCommand& command) {
    const studies::StudyPlan plan = make_plan(command);
    const unsigned threads = thread_count(command);
    if (command.dry_run) return describe_plan(plan, threads);
    if (!command.quiet) {
        for (const std::string& warning : plan.warnings) fmt::print(stderr, "note: {}\n", warning);
    }
    const std::filesystem::path out =
        command.out.empty() ? std::filesystem::path("results") / plan.spec.name : command.out;
    make_folder(out);
    expect_room_for_results(out);
    auto store = studies::Store::create_or_resume(out / "results.sqlite", plan);

    const auto start = std::chrono::steady_clock::now();
    ProgressDisplay progress(ProgressDisplay::style(command.quiet));
    studies::RunOptions options;
    options.threads = threads;
    options.stop = &stop_on_signals();
    options.report = [&](const studies::Progress& state) { progress.show(state); };
    const auto outcome = studies::run_study(store, options);
    progress.finish();
    end_on_signals();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (outcome == studies::RunOutcome::complete && store.context().empty()) {
        store.set_context(describe_run(reproduce(plan.spec, command.study, command.trials), threads, seconds));
    }

    store.seal();
    const auto results = studies::evaluate(store);
    write_results(out, store, results, all_formats());
    if (!command.quiet) fmt::print("{}", reports::terminal_summary(results));
    if (!command.quiet) fmt::print("\nResults: {}\n", (out / "report.md").string());
    if (outcome == studies::RunOutcome::complete) return ExitCode::passed;
    fmt::print(stderr, "stopped early; what was done is saved. Run the same command again to go on.\n");
    return ExitCode::interrupted;
}

}  // namespace ff::app

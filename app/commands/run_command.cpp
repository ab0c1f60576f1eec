#include "app/commands/run_request.hpp"

#include "app/commands/context/run_context.hpp"
#include "app/folders/output_folder.hpp"
#include "app/folders/result_files.hpp"
#include "app/folders/shipped_files.hpp"
#include "app/process/limits.hpp"
#include "app/process/processes.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"
#include "app/terminal/progress.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "reports/files/output_file.hpp"
#include "reports/terminal/terminal.hpp"
#include "reports/text/numbers.hpp"
#include "studies/results/resources.hpp"
#include "studies/run/measured_costs.hpp"
#include "studies/run/merge.hpp"
#include "studies/run/run.hpp"
#include "studies/store/records.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::app {
namespace {

constexpr std::string_view store_name = "results.sqlite";

/// The command that gives the same results.
std::string reproduce(const RunCommand& command, const studies::StudySpec& spec) {
    std::string text = command.convergence
                           ? studies::convergence_command(*command.convergence)
                           : fmt::format("ffstudy {} {}", command.radiosity ? "radiosity" : "run", command.study);
    const auto add = [&](std::string_view option, const auto& value) {
        if (value) text += fmt::format(" --{} {}", option, *value);
    };
    if (command.radiosity) {
        if (!command.radiosity->reflectance.empty())
            text += fmt::format(" --reflectance {}", command.radiosity->reflectance);
        if (!command.radiosity->emission.empty()) text += fmt::format(" --emission {}", command.radiosity->emission);
        add("patch-trials", command.radiosity->patch_trials);
    }
    add("trials", command.trials);
    add("until", command.until);
    add("level", command.level);
    return text + fmt::format(" --seed {}", spec.seed.value);
}

/// A finished shard leaves its store, without what an interruption reported. Reports come from all shards together.
ExitCode finish_shard(const studies::Shard& shard, OutputFolder& out, bool quiet) {
    for (const std::string& name : usual_files()) out.remove(name);
    if (!quiet) {
        print_folded("shard {}/{} is complete: {}\nWhen all {} are: ffstudy merge FOLDER... --out FOLDER\n",
                     shard.index, shard.count, (out.path() / store_name).string(), shard.count);
    }
    return ExitCode::passed;
}

studies::RunOptions options_of(const RunRequest& request, const Processes& processes) {
    studies::RunOptions options;
    options.threads = request.threads;
    options.shard = request.shard;
    options.process = processes.part();
    options.stop = &stop_flag();
    options.drop = &drop_flag();
    return options;
}

/// The work of a process other than the first one: carries out its units and hands them over. It prints nothing: the
/// first process finds the same faults of the command, and ends all processes.
ExitCode assist(const Processes& processes, const RunCommand& command) {
    std::optional<RunRequest> request;
    std::exception_ptr failure;
    try {
        request = check(command, processes);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure && command.dry_run) return ExitCode::passed;
    const std::vector<bool> finished = processes.share_finished({});
    if (failure) std::rethrow_exception(failure);
    // An end here would also end the first process, which saves and writes the reports.
    never_end_on_signals();
    const Limits limits(request->max_time, request->max_memory);
    processes.assist([&] {
        studies::carry_out_units(request->plan, finished, options_of(*request, processes),
                                 [&](const studies::UnitRecord& record) { processes.send(studies::to_words(record)); });
    });
    return ExitCode::passed;
}

void save_study(const std::filesystem::path& file, const studies::StudySpec& spec) {
    if (file.extension() != ".toml") {
        throw UserError("--save-study {}: study files end in .toml. Choose such a name.", file.string());
    }
    const OutputFolder folder(reports::folder_of(file), "study file");
    reports::write_file(file, studies::to_toml(spec));
}

std::string reused_in_words(const studies::CommonTrials& common, const std::string& difference) {
    const std::string trials = fmt::format("{} of {} trials are there already", common.reused, common.wanted);
    return difference.empty() ? trials : fmt::format("{}, from a study that differs in {}", trials, difference);
}

void expect_wanted(const studies::CommonTrials& common, const std::filesystem::path& file,
                   const std::string& difference) {
    if (common.left_behind == 0) return;
    if (common.beyond > 0) {
        throw UserError(
            "{}: has all trials of this study and {} beyond them (it differs in {}). Choose another --out, or add "
            "--replace, which keeps the old store aside.",
            file.string(), common.beyond, difference);
    }
    const std::uint64_t saved = common.reused + common.left_behind;
    throw UserError(
        "{}: holds another study (differs in {}): {} of its {} trials are none of this one. Choose another --out, or "
        "add --replace, which keeps the old store aside.",
        file.string(), difference, common.left_behind, saved);
}

/// A name that no file has.
std::filesystem::path place_aside(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        auto file = folder / fmt::format("results.before-{}.sqlite", number);
        if (!std::filesystem::exists(file)) return file;
    }
}

/// Leaves the store without a log beside it, so that it can be moved. @throws UserError where another program has it
/// open
studies::Store open_whole(const std::filesystem::path& file) {
    studies::Store store = studies::Store::create_or_resume(file, studies::Store::open(file).plan());
    if (!store.seal()) {
        throw UserError("{}: another program has it open. Close that one, or choose another --out.", file.string());
    }
    return store;
}

/// Where a folder has the store of another study, a store of this one replaces it and begins with the trials that both
/// share. An old store with other trials is kept beside it.
/// @param replace  whether trials that are not part of this study may be set aside
/// @return what is reused, in words; empty where the folder has no other study
/// @throws UserError where trials would have to be set aside but may not; IoError
std::string grow_study(OutputFolder& folder, const studies::StudyPlan& plan, bool replace, unsigned threads) {
    const auto file = folder.path() / store_name;
    if (!std::filesystem::exists(file)) return {};
    const std::string difference = studies::difference_of_study(file, plan.spec);
    if (difference.empty()) return {};
    const auto grown = folder.make_workshop() / store_name;
    studies::CommonTrials common;
    {
        const studies::Store stored = open_whole(file);
        common = common_trials(stored, plan);
        if (!replace) expect_wanted(common, file, difference);
        studies::Store store = studies::Store::create_or_resume(grown, plan);
        adopt(stored, file, common, store, threads);
        studies::Context context = stored.context();
        context.erase("command");  // this study has its own
        store.set_context(context);
        store.seal();
    }
    std::string text = reused_in_words(common, difference);
    if (common.left_behind > 0) {
        const auto aside = place_aside(folder.path());
        std::filesystem::rename(file, aside);
        text += fmt::format("; the old store is kept as {}", aside.string());
    }
    std::filesystem::rename(grown, file);
    return text;
}

/// Says in the same words what would be reused, without doing anything.
std::string describe_growth(const std::filesystem::path& folder, const studies::StudyPlan& plan) {
    const auto file = folder / store_name;
    if (!std::filesystem::exists(file)) return {};
    const std::string difference = studies::difference_of_study(file, plan.spec);
    const auto common = common_trials(studies::Store::open(file), plan);
    return reused_in_words(common, difference) +
           (common.left_behind == 0
                ? ""
                : fmt::format("; {} are none of this study, and need --replace", common.left_behind));
}

ExitCode describe_plan(const RunRequest& request, const std::filesystem::path& out) {
    if (const std::string text = describe_growth(out, request.plan); !text.empty()) print_folded("{}\n\n", text);
    print_folded("{}about {} of memory, {} on the disk\n",
                 reports::terminal_plan(request.plan, request.threads, style_of_stdout()),
                 size_in_words(studies::expected_memory(request.plan, request.threads)),
                 size_in_words(studies::expected_store_size(request.plan)));
    return ExitCode::passed;
}

/// @throws UserError where the finished store would exceed the free space on the disk by far, and the run has no other
/// end
void expect_room_on_disk(const RunRequest& request, const std::filesystem::path& out, bool quiet) {
    std::error_code error;
    const std::uint64_t free = std::filesystem::space(out, error).available;
    if (error) return;
    const std::uint64_t held = std::filesystem::file_size(out / "results.sqlite", error);
    const std::uint64_t expected = studies::expected_store_size(request.plan);
    const std::uint64_t more = expected - std::min(expected, error ? 0 : held);
    if (more <= free) return;
    const std::string text = fmt::format("{}: about {} will be written, and {} are free", out.string(),
                                         size_in_words(more), size_in_words(free));
    // The expected size is right within a factor of two; a goal or a time limit may end the run earlier.
    if (more / 2 > free && !request.plan.spec.until && !request.max_time) {
        throw UserError("{} (the run would end with a full disk). Take fewer trials, another --out, or a --max-time.",
                        text);
    }
    if (!quiet) say("note: {}.\n", text);
}

/// A folder that is resumed is written to.
std::filesystem::path out_folder(const RunCommand& command, const studies::StudySpec& spec) {
    if (!command.out.empty()) return command.out;
    return is_folder_of_study(command.study) ? std::filesystem::path(command.study)
                                             : std::filesystem::path("results") / spec.name;
}

}  // namespace

ExitCode run(const RunCommand& command) {
    const Processes processes;
    if (!processes.leads()) return assist(processes, command);
    const RunRequest request = check(command, processes);
    const studies::StudyPlan& plan = request.plan;
    if (!command.study_file.empty()) save_study(command.study_file, plan.spec);
    const auto folder = out_folder(command, plan.spec);
    if (command.dry_run) return describe_plan(request, folder);
    if (!command.quiet) {
        for (const std::string& warning : plan.warnings) say("note: {}\n", warning);
    }
    const auto templates = find_templates(command.templates);
    OutputFolder out(folder, owner_of(plan.spec));
    expect_room_on_disk(request, out.path(), command.quiet);
    const std::string reused = grow_study(out, plan, command.replace, request.threads);
    if (!reused.empty() && !command.quiet) say("note: {}.\n", reused);
    studies::Store store = open_or_create(out, plan);
    if (is_verbose()) {
        const std::string text = reports::terminal_plan(plan, request.threads, {});
        for (const std::string_view line : split_at('\n', text)) say("{}\n", line);
    }

    const auto start = std::chrono::steady_clock::now();
    ProgressDisplay progress(command.quiet);
    studies::RunOptions options = options_of(request, processes);
    if (!processes.alone()) {
        processes.share_finished(store.finished_units());
        options.others = [&](const studies::Deliver& deliver) {
            processes.receive(
                [&](std::span<const std::uint64_t> words) { return deliver(studies::from_words(words)); });
        };
    }
    stop_gracefully_on_signals(command.quiet ? ""
                                             : fmt::format("\nstopping: finishing {} (two seconds at most); Ctrl-C "
                                                           "again to drop {}\n",
                                                           reports::counted(request.threads, "work unit"),
                                                           request.threads == 1 ? "it" : "them"));
    bool worked = false;
    studies::MeasuredCosts costs(plan);
    options.report = [&](const studies::RunProgress& state) {
        worked = true;
        progress.show(state);
        costs.add(state);
    };
    std::optional<Limits> limits(std::in_place, request.max_time, request.max_memory);
    const auto outcome = studies::run_study(store, options);
    limits.reset();
    progress.finish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    studies::Context context = store.context();
    studies::Context now;
    if (!costs.in_context().empty()) now[std::string(studies::costs_key)] = costs.in_context();
    if (outcome == studies::RunOutcome::complete && (worked || !context.contains("command"))) {
        now.merge(describe_run(reproduce(command, plan.spec), request.threads, seconds));
        if (!costs.in_words().empty()) now["processor_time_per_trial"] = costs.in_words();
    }
    if (!now.empty()) {
        studies::add_context(context, now);
        store.set_context(context);
    }

    seal(store, command.quiet);
    if (!request.shard.is_whole() && outcome == studies::RunOutcome::complete && !store.is_complete())
        return finish_shard(request.shard, out, command.quiet);
    const auto [results, to_the_end] = evaluate_until_stopped(store, command.quiet);
    write_results(out, {store, results, templates}, usual_formats);
    if (!command.quiet) {
        print_folded(reports::terminal_summary(results, style_of_stdout()));
        if (!costs.in_words().empty()) print_folded("\nProcessor time per trial, measured: {}\n", costs.in_words());
        print_folded("\nResults: {}\n", (out.path() / "report.html").string());
    }
    if (outcome != studies::RunOutcome::complete)
        say("stopped early; what was done is saved. Run the same command again to resume.\n");
    if (outcome != studies::RunOutcome::complete || !to_the_end) return ExitCode::interrupted;
    return studies::all_reached(results.until) ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace ff::app

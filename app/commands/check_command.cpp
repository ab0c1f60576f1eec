#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/commands/check_estimates.hpp"
#include "app/commands/look_ledger.hpp"
#include "app/commands/run_context.hpp"
#include "app/folders/check_files.hpp"
#include "app/folders/output_folder.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/messages.hpp"
#include "app/terminal/terminal_style.hpp"

#include "core/support/error.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/files/output_file.hpp"
#include "reports/json/json.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "studies/gates/at_gate.hpp"
#include "studies/gates/bands_file.hpp"
#include "studies/gates/estimate_gates.hpp"
#include "studies/gates/gate_run.hpp"
#include "studies/gates/seed_sweep.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>
#include <string>
#include <utility>

namespace ff::app {
namespace {

using studies::Against;
using studies::GatePlan;
using studies::GatePurpose;
using studies::GatesSpec;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_seeds = 1'000'000;

/// What all ways of running gates need.
struct Check {
    const CheckCommand& command;
    GatesSpec spec;
    std::optional<studies::Baseline> baseline;
    studies::GateRunOptions options;

    [[nodiscard]] const studies::Baseline* baseline_or_null() const { return baseline ? &*baseline : nullptr; }
    void print(const std::string& text) const {
        if (command.quiet) return;
        fmt::print("{}", text);
        std::fflush(stdout);
    }
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Check begin(const CheckCommand& command) {
    admit_code_of(command.bands, studies::FileKind::bands, command.outside);
    Check check{command, studies::load_bands(command.bands), std::nullopt, {}};
    if (command.seed) check.spec.seed = checked_seed(*command.seed);
    if (command.fresh_seed) check.spec.seed = fresh_seed();
    if (!command.baseline.empty())
        check.baseline = studies::parse_baseline(studies::read_text_file(command.baseline, studies::FileKind::baseline),
                                                 command.baseline.string());
    check.options.threads = thread_count(command.threads);
    return check;
}

/// All gates, so that what is wrong with one is found before any is run.
std::vector<GatePlan> prepare(const Check& check, GatePurpose purpose) {
    std::vector<GatePlan> plans;
    for (std::size_t gate = 0; gate < check.spec.gates.size(); ++gate) {
        if (check.spec.gates[gate].from_estimates()) continue;
        const bool stored = check.spec.gates[gate].against == Against::baseline;
        if (purpose == GatePurpose::save_baseline && !stored) continue;
        plans.push_back(studies::at_gate(
            check.spec.gates[gate], [&] { return prepare_gate(check.spec, gate, purpose, check.baseline_or_null()); }));
    }
    return plans;
}

// Signals end the program at once: verdicts are written after every gate. So these go on to their end.
std::uint64_t plan(const Check& check, GatePlan& gate) {
    return studies::at_gate(check.spec.gates[gate.gate],
                            [&] { return plan_trials(check.spec, gate, check.options).value(); });
}

studies::GateResult run(const Check& check, const GatePlan& gate, std::uint64_t pilot) {
    studies::GateResult result = studies::at_gate(check.spec.gates[gate.gate],
                                                  [&] { return run_gate(check.spec, gate, check.options).value(); });
    result.evaluations += pilot;
    return result;
}

double seconds_per_trial(double seconds, unsigned threads, std::uint64_t trials) {
    return seconds * threads / static_cast<double>(std::max<std::uint64_t>(1, trials));
}

/// Speed beside the baseline's: it depends on the machine, so it is told and not judged.
std::string speed_note(const GatePlan& gate, double seconds, unsigned threads, std::uint64_t looks) {
    if (gate.stored_seconds_per_trial == 0) return {};
    const std::uint64_t trials = looks * std::accumulate(gate.trials.begin(), gate.trials.end(), std::uint64_t{0});
    return fmt::format("{:.3g} s a trial and core; the baseline took {:.3g} s",
                       seconds_per_trial(seconds, threads, trials), gate.stored_seconds_per_trial);
}

ExitCode exit_code(studies::Verdict verdict) {
    switch (verdict) {
        case studies::Verdict::pass:
            return ExitCode::passed;
        case studies::Verdict::fail:
            return ExitCode::failed;
        case studies::Verdict::inconclusive:
            break;
    }
    return ExitCode::inconclusive;
}

/// The folder for these files, once it is certain that they may be written.
OutputFolder open_folder(const std::filesystem::path& out, const std::vector<std::string>& files) {
    end_on_signals(fmt::format("\nstopped early; the gates that were done are in {}.\n", out.string()));
    return {out, "check", files};
}

ExitCode show_plan(Check& check) {
    auto plans = prepare(check, check.command.save_baseline.empty() ? GatePurpose::check : GatePurpose::save_baseline);
    const auto files = plan_file(check.command, check.spec);
    for (GatePlan& gate : plans) plan(check, gate);
    fmt::print("{}", reports::gates_plan(check.spec, files, plans, check.options.threads));
    return ExitCode::passed;
}

ExitCode save_baseline(Check& check) {
    auto plans = prepare(check, GatePurpose::save_baseline);
    if (plans.empty())
        throw UserError(
            fmt::format("{}: no gate compares with a baseline (there is nothing to save). Add reference = "
                        "\"baseline\" to a gate, or one of kind \"efficiency\".",
                        check.command.bands.string()));
    studies::Baseline baseline;
    for (GatePlan& gate : plans) {
        plan(check, gate);
        const auto start = Clock::now();
        auto stored = run_to_store(check.spec, gate, check.options).value();
        const auto trials = std::accumulate(gate.trials.begin(), gate.trials.end(), std::uint64_t{0});
        stored.seconds_per_trial = seconds_per_trial(seconds_since(start), check.options.threads, trials);
        check.print(fmt::format("saved  {:<28}  {} trials\n", stored.gate, trials));
        baseline.gates.push_back(std::move(stored));
    }
    {
        const auto parent = check.command.save_baseline.parent_path();
        const OutputFolder folder(parent.empty() ? "." : parent, "baseline");
        reports::write_file(check.command.save_baseline, baseline_json(baseline));
    }
    check.print(fmt::format("\nBaseline: {}\n", check.command.save_baseline.string()));
    return ExitCode::passed;
}

/// @throws UserError where the bands file and --estimates do not go together
void expect_estimates(const Check& check) {
    const auto& gates = check.spec.gates;
    const auto wanting =
        std::find_if(gates.begin(), gates.end(), [](const auto& gate) { return gate.from_estimates(); });
    const bool given = !check.command.estimates.empty();
    if (wanting != gates.end() && !given)
        throw UserError(
            fmt::format("{}: gate \"{}\" is on estimates of another program (none are given). Add "
                        "--estimates FILE.csv.",
                        wanting->place, wanting->name));
    if (wanting == gates.end() && given)
        throw UserError(
            fmt::format("--estimates {} (no gate of {} has a quantity, so none would be judged). Add a gate "
                        "with quantity = \"...\", or leave the option out.",
                        check.command.estimates.string(), check.command.bands.string()));
    if (!given && !check.command.against.empty())
        throw UserError("--against (it is what --estimates FILE is compared with, and there is none). Add it.");
    if (given && (check.command.seed_sweep > 0 || !check.command.save_baseline.empty()))
        throw UserError(
            "--estimates (the file has one set of random numbers; --seed-sweep and --save-baseline run "
            "new ones). Leave one of them out.");
}

ExitCode check_once(Check& check, const std::filesystem::path& out) {
    auto plans = prepare(check, GatePurpose::check);
    auto judged = judge_file(check.command, check.spec);
    const auto start = Clock::now();
    std::vector<std::uint64_t> pilots;
    for (GatePlan& gate : plans) pilots.push_back(plan(check, gate));
    OutputFolder folder = open_folder(out, {"verdicts.csv", "verdicts.json", "junit.xml", "context.json"});
    auto context =
        describe_run(fmt::format("ffstudy check {} --seed {}", check.command.bands.string(), check.spec.seed.value),
                     check.options.threads, 0);
    reports::JunitContext junit{context["date_utc"].substr(0, 19), context["host"], {}, {}};
    studies::CheckResults results{check.spec, {}};
    write_verdicts(folder, results, junit);
    check.print(reports::gates_heading(check.spec));
    const auto colour = style_of_stdout().colour;
    for (studies::GateResult& result : judged) {
        check.print(reports::gate_line(result, colour));
        results.results.push_back(std::move(result));
        junit.seconds.push_back(0);
        junit.notes.emplace_back();
    }
    if (!judged.empty()) write_verdicts(folder, results, junit);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const GatePlan& gate = plans[i];
        const auto begun = Clock::now();
        results.results.push_back(run(check, gate, pilots[i]));
        const studies::GateResult& result = results.results.back();
        junit.seconds.push_back(seconds_since(begun));
        junit.notes.push_back(speed_note(gate, junit.seconds.back(), check.options.threads, result.looks));
        write_verdicts(folder, results, junit);
        check.print(reports::gate_line(result, colour));
        if (!junit.notes.back().empty()) check.print(fmt::format("{:<12}  {}\n", "", junit.notes.back()));
    }
    context["seconds"] = fmt::format("{:.2f}", seconds_since(start));
    folder.write("context.json", reports::context_json(context));
    check.print(reports::gates_summary(results));
    check.print(fmt::format("Results: {}\n", out.string()));
    return exit_code(results.verdict());
}

studies::Verdict verdict_of(ExitCode code) {
    return code == ExitCode::passed   ? studies::Verdict::pass
           : code == ExitCode::failed ? studies::Verdict::fail
                                      : studies::Verdict::inconclusive;
}

/// One more look at a commit, with what earlier ones have left of alpha.
ExitCode check_again(Check& check, const std::filesystem::path& out) {
    const auto look = describe_look(check.command, check.spec.seed.value);
    const auto file = ledger_file(check.command);
    const auto next = begin_look(file, look, check.spec);
    if (next.failed) {
        check.print(fmt::format("{}: failed at an earlier look ({}); a rerun does not take that back.\n", look.commit,
                                file.string()));
        return ExitCode::failed;
    }
    if (next.repeated) {
        check.print(fmt::format("{}: the same data were judged before ({}): {}. Another look needs other data.\n",
                                look.commit, file.string(), name(next.earlier)));
        return exit_code(next.earlier);
    }
    const double alpha = check.spec.alpha;
    check.spec = studies::at_look(check.spec, next.number);
    check.print(
        fmt::format("look {} at {}: alpha {:.3g} of {:.3g}\n", next.number, look.commit, check.spec.alpha, alpha));
    try {
        const ExitCode code = check_once(check, out);
        end_look(file, look, verdict_of(code));
        return code;
    } catch (const UserError&) {
        end_look(file, look, std::nullopt);  // nothing was judged
        throw;
    }
}

/// Verdicts of all gates.
std::vector<studies::Verdict> verdicts_with_seed(Check check, std::uint64_t seed) {
    check.spec.seed = checked_seed(seed);
    std::vector<studies::Verdict> verdicts;
    for (GatePlan& gate : prepare(check, GatePurpose::check))
        verdicts.push_back(run(check, gate, plan(check, gate)).verdict);
    return verdicts;
}

/// Every seed from the file's on, each a check of its own; several at once, each on one thread.
ExitCode sweep(Check& check, const std::filesystem::path& out) {
    const std::uint64_t seeds = check.command.seed_sweep;
    if (seeds > most_seeds)
        throw UserError(fmt::format("--seed-sweep {} (at most {} seeds). Take fewer.", seeds, most_seeds));
    static_cast<void>(prepare(check, GatePurpose::check));
    OutputFolder folder = open_folder(out, {"seed_sweep.csv"});
    const std::uint64_t first = check.spec.seed.value;
    const unsigned threads = std::exchange(check.options.threads, 1u);
    std::vector<studies::SeedSweep> sweeps;
    for (const studies::Gate& gate : check.spec.gates) sweeps.push_back({gate.name, 0, 0, 0});
    check.print(reports::gates_heading(check.spec));
    for (std::uint64_t done = 0; done < seeds;) {
        std::vector<std::vector<studies::Verdict>> verdicts(std::min<std::uint64_t>(threads, seeds - done));
        studies::for_each_index(verdicts.size(), static_cast<unsigned>(verdicts.size()),
                                [&](std::uint64_t i) { verdicts[i] = verdicts_with_seed(check, first + done + i); });
        done += verdicts.size();
        for (const auto& of_seed : verdicts) {
            for (std::size_t gate = 0; gate < of_seed.size(); ++gate) add_verdict(sweeps[gate], of_seed[gate]);
        }
        folder.write("seed_sweep.csv",
                     [&](std::ostream& file) { reports::write_seed_sweep_csv(file, check.spec, sweeps); });
    }
    check.print(reports::seed_sweep_table(check.spec, sweeps));
    check.print(fmt::format("\nResults: {}\n", (out / "seed_sweep.csv").string()));
    const auto any = [&](auto rate) {
        return std::any_of(sweeps.begin(), sweeps.end(),
                           [&](const studies::SeedSweep& s) { return rate(s, check.spec).exceeded; });
    };
    if (any(studies::failure_rate)) return ExitCode::failed;
    return any(studies::inconclusive_rate) ? ExitCode::inconclusive : ExitCode::passed;
}

}  // namespace

ExitCode check(const CheckCommand& command) {
    Check check = begin(command);
    expect_estimates(check);
    const auto out = command.out.empty() ? std::filesystem::path("results") / check.spec.name : command.out;
    if (command.fresh_seed)
        check.print(fmt::format("fresh seed {}; again with --seed {}\n", check.spec.seed.value, check.spec.seed.value));
    if (!command.again.empty()) static_cast<void>(describe_look(command, check.spec.seed.value));
    if (command.dry_run) return show_plan(check);
    if (!command.save_baseline.empty()) return save_baseline(check);
    if (command.seed_sweep > 0) return sweep(check, out);
    return command.again.empty() ? check_once(check, out) : check_again(check, out);
}

}  // namespace ff::app

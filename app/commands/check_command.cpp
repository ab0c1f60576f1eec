#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/context/run_context.hpp"
#include "app/commands/gates/check_estimates.hpp"
#include "app/commands/gates/gate_commands.hpp"
#include "app/folders/output_folder.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/files/output_file.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "reports/terminal/terminal.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/gates/gate_run.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/run/parallel.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>
#include <utility>

namespace ff::app {
namespace {

using studies::gates::Against;
using studies::gates::GatePurpose;
using studies::gates::Plan;
using studies::gates::Spec;
using Clock = std::chrono::steady_clock;

struct FullCheckCommand : CheckCommand {
    OutsideOptions outside;
};

/// Data that all ways of running gates need.
struct Check {
    const CheckCommand& command;
    Spec spec;
    std::optional<studies::gates::Baseline> baseline;
    studies::gates::GateRunOptions options;

    [[nodiscard]] CheckSession session(PrepareGates prepare_gates) const {
        const auto line = fmt::format("ffstudy check {} --seed {}", command.bands.string(), spec.seed.value);
        return {command, spec, describe_run(line, options.threads, 0), std::move(prepare_gates)};
    }
};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Check begin(const FullCheckCommand& command) {
    admit_code_of(command.bands, studies::FileKind::bands, command.outside);
    Check check{command, studies::gates::load_bands(command.bands, studies::gates::read_experiment), std::nullopt, {}};
    if (command.seed) check.spec.seed = checked_seed(*command.seed);
    if (command.fresh_seed) check.spec.seed = fresh_seed();
    if (!command.baseline.empty())
        check.baseline = studies::gates::parse_baseline(
            studies::read_text_file(command.baseline, studies::FileKind::baseline), command.baseline.string());
    check.options.threads = thread_count(command.threads);
    return check;
}

/// Prepares all gates, so that a fault of any is found before the first is run.
std::vector<Plan> prepare(const Check& check, GatePurpose purpose) {
    const studies::gates::Baseline* baseline = check.baseline ? &*check.baseline : nullptr;
    std::vector<Plan> plans;
    for (std::size_t gate = 0; gate < check.spec.gates.size(); ++gate) {
        if (check.spec.gates[gate].from_estimates()) continue;
        const bool stored = check.spec.gates[gate].against == Against::baseline;
        if (purpose == GatePurpose::save_baseline && !stored) continue;
        plans.push_back(studies::gates::at_gate(check.spec.gates[gate],
                                                [&] { return prepare_gate(check.spec, gate, purpose, baseline); }));
    }
    return plans;
}

// Signals end the program at once: verdicts are written after every gate. So these run to their end.
std::uint64_t plan(const Check& check, Plan& gate) {
    return studies::gates::at_gate(check.spec.gates[gate.gate],
                                   [&] { return plan_trials(check.spec, gate, check.options).value(); });
}

studies::gates::GateResult run_planned(const Check& check, const Plan& gate, std::uint64_t pilot) {
    studies::gates::GateResult result = studies::gates::at_gate(
        check.spec.gates[gate.gate], [&] { return run_gate(check.spec, gate, check.options).value(); });
    result.evaluations += pilot;
    return result;
}

double seconds_per_trial(double seconds, unsigned threads, std::uint64_t trials) {
    return seconds * threads / static_cast<double>(std::max<std::uint64_t>(1, trials));
}

/// Speed compared with the baseline's: it depends on the machine, so it is reported but not judged.
std::string speed_note(const Plan& gate, double seconds, unsigned threads, std::uint64_t looks) {
    if (gate.stored_seconds_per_trial == 0) return {};
    const std::uint64_t trials = looks * std::accumulate(gate.trials.begin(), gate.trials.end(), std::uint64_t{0});
    return fmt::format("{:.3g} s a trial and core; the baseline took {:.3g} s",
                       seconds_per_trial(seconds, threads, trials), gate.stored_seconds_per_trial);
}

ExitCode show_plan(Check& check) {
    auto plans = prepare(check, check.command.save_baseline.empty() ? GatePurpose::check : GatePurpose::save_baseline);
    const auto files = plan_file(check.command, check.spec);
    for (Plan& gate : plans) plan(check, gate);
    print_folded(reports::gates_plan(check.spec, files, plans, check.options.threads));
    return ExitCode::passed;
}

ExitCode save_baseline(Check& check, const CheckSession& session) {
    auto plans = prepare(check, GatePurpose::save_baseline);
    if (plans.empty())
        throw UserError(
            "{}: no gate compares with a baseline (there is nothing to save). Add reference = "
            "\"baseline\" to a gate, or one of kind \"efficiency\".",
            check.command.bands.string());
    studies::gates::Baseline baseline;
    for (Plan& gate : plans) {
        plan(check, gate);
        const auto start = Clock::now();
        auto stored = run_to_store(check.spec, gate, check.options).value();
        const auto trials = std::accumulate(gate.trials.begin(), gate.trials.end(), std::uint64_t{0});
        stored.seconds_per_trial = seconds_per_trial(seconds_since(start), check.options.threads, trials);
        session.print(fmt::format("saved  {:<28}  {} trials\n", stored.gate, trials));
        baseline.gates.push_back(std::move(stored));
    }
    {
        const OutputFolder folder(reports::folder_of(check.command.save_baseline), "baseline");
        reports::write_file(check.command.save_baseline, baseline_json(baseline));
    }
    session.print(fmt::format("\nBaseline: {}\n", check.command.save_baseline.string()));
    return ExitCode::passed;
}

/// Plans all gates before it runs the first.
RunGates prepare_to_run(const Check& check) {
    auto plans = prepare(check, GatePurpose::check);
    std::vector<std::uint64_t> pilots;
    for (Plan& gate : plans) pilots.push_back(plan(check, gate));
    return [check, plans = std::move(plans), pilots = std::move(pilots)](const Tell& tell) {
        for (std::size_t i = 0; i < plans.size(); ++i) {
            const auto begun = Clock::now();
            auto result = run_planned(check, plans[i], pilots[i]);
            const double seconds = seconds_since(begun);
            const std::string note = speed_note(plans[i], seconds, check.options.threads, result.looks);
            tell(std::move(result), seconds, note);
        }
    };
}

/// Verdicts of all gates.
std::vector<studies::gates::Verdict> verdicts_with_seed(Check check, std::uint64_t seed) {
    check.spec.seed = checked_seed(seed);
    std::vector<studies::gates::Verdict> verdicts;
    for (Plan& gate : prepare(check, GatePurpose::check))
        verdicts.push_back(run_planned(check, gate, plan(check, gate)).verdict);
    return verdicts;
}

/// Runs a separate check for each seed, from the file's seed on; several at once, each on one thread.
ExitCode sweep(Check& check, const CheckSession& session) {
    const auto out = session.out();
    const std::uint64_t seeds = check.command.seed_sweep;
    constexpr std::uint64_t most_seeds = 1'000'000;
    if (seeds > most_seeds) throw UserError("--seed-sweep {} (at most {} seeds). Take fewer.", seeds, most_seeds);
    if (check.baseline)
        throw UserError(
            "--seed-sweep with --baseline (all seeds would share the error of one baseline, so that the rate of "
            "failures says nothing of alpha). Give these gates a number as reference, or leave them out.");
    static_cast<void>(prepare(check, GatePurpose::check));
    OutputFolder folder = open_folder(out, {"seed_sweep.csv"});
    const std::uint64_t first = check.spec.seed.value;
    const unsigned threads = std::exchange(check.options.threads, 1u);
    std::vector<studies::gates::SeedSweep> sweeps;
    for (const studies::gates::Gate& gate : check.spec.gates) sweeps.push_back({gate.name, 0, 0, 0});
    session.print(reports::gates_heading(check.spec));
    for (std::uint64_t done = 0; done < seeds;) {
        std::vector<std::vector<studies::gates::Verdict>> verdicts(std::min<std::uint64_t>(threads, seeds - done));
        studies::for_each_index(verdicts.size(), static_cast<unsigned>(verdicts.size()),
                                [&](std::uint64_t i) { verdicts[i] = verdicts_with_seed(check, first + done + i); });
        done += verdicts.size();
        for (const auto& of_seed : verdicts) {
            for (std::size_t gate = 0; gate < of_seed.size(); ++gate) add_verdict(sweeps[gate], of_seed[gate]);
        }
        folder.write("seed_sweep.csv",
                     [&](std::ostream& file) { reports::write_seed_sweep_csv(file, check.spec, sweeps); });
    }
    session.print(reports::seed_sweep_table(check.spec, sweeps));
    session.print(fmt::format("\nResults: {}\n", (out / "seed_sweep.csv").string()));
    const auto any = [&](auto rate) {
        return std::any_of(sweeps.begin(), sweeps.end(),
                           [&](const studies::gates::SeedSweep& s) { return rate(s, check.spec).exceeded; });
    };
    if (any(studies::gates::failure_rate)) return ExitCode::failed;
    return any(studies::gates::inconclusive_rate) ? ExitCode::inconclusive : ExitCode::passed;
}

ExitCode check_gates(const FullCheckCommand& command) {
    Check check = begin(command);
    expect_estimates(command, check.spec);
    if (!command.save_baseline.empty() && !command.estimates.empty()) {
        save_means(command);
        return ExitCode::passed;
    }
    const CheckSession session = check.session([check](const Spec& spec) {
        Check of_look = check;
        of_look.spec = spec;
        return prepare_to_run(of_look);
    });
    if (command.fresh_seed)
        session.print(
            fmt::format("fresh seed {}; again with --seed {}\n", check.spec.seed.value, check.spec.seed.value));
    if (!command.again.empty()) static_cast<void>(describe_look(command, check.spec));
    if (command.dry_run) return show_plan(check);
    if (!command.save_baseline.empty()) return save_baseline(check, session);
    if (command.seed_sweep > 0) return sweep(check, session);
    return judge(session);
}

}  // namespace

void add_check(ProgramDefinition& program) {
    const auto [sub, command] = program.command<FullCheckCommand>(checks, "check", check_summary, check_gates);
    add_options_of_files(sub, command);
    sub.option("--seed", command.seed, "Seed of all random numbers (default: the file's)",
               {.numbers = Numbers::not_negative});
    sub.option("--fresh-seed", command.fresh_seed, "A new seed, printed", {.excludes = {"--seed"}});
    sub.option("--seed-sweep", command.seed_sweep, "Check with N seeds; report failure rates against alpha",
               {.numbers = Numbers::positive, .excludes = {"--json"}});
    sub.option("--baseline", command.baseline, "Baseline file to compare with",
               {.type = "FILE", .excludes = {"--save-baseline"}});
    add_outside_options(sub, command.outside, OutsideCodeFrom::files_too);
    sub.option("--threads", command.threads, "Threads; verdicts do not depend on them (default: all cores)");
}

}  // namespace ff::app

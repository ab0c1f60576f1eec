#include "app/commands/gates/check_estimates.hpp"

#include "core/support/error.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/reported/reported_gates.hpp"

#include <algorithm>

namespace ff::app {
namespace {

using studies::gates::Spec;

/// The results of `make` for each gate on what another program reported; nothing is run for these gates.
template <class Make>
auto each_on_estimates(const Spec& spec, const Make& make) {
    std::vector<decltype(make(spec.gates.front()))> results;
    for (const studies::gates::Gate& gate : spec.gates) {
        if (gate.from_estimates()) results.push_back(studies::gates::at_gate(gate, [&] { return make(gate); }));
    }
    return results;
}

/// @throws UserError where a gate needs means with their errors, and trials are given
void expect_gates_on_trials(const CheckCommand& command, const Spec& spec) {
    bool two_files = false;
    for (const studies::gates::Gate& gate : spec.gates) {
        const bool of_trials =
            gate.kind == studies::gates::GateKind::bias || gate.kind == studies::gates::GateKind::std;
        const bool of_distributions = gate.kind == studies::gates::GateKind::distribution;
        two_files = two_files || (of_distributions && !gate.law);
        if (!gate.from_estimates() || (of_trials && gate.reference)) continue;
        if (of_distributions && (gate.law || !command.against.empty())) continue;
        throw UserError(
            "{}: gate \"{}\" ({} is of trials, which are gated on bias and std beside a number, and on "
            "their distribution beside a known one or --against). Give means with standard errors, or a "
            "reference.",
            gate.place, gate.name, command.estimates.string());
    }
    if (!command.against.empty() && !two_files)
        throw UserError(
            "--against {} ({} has trials, and no gate compares their distribution with that of others; "
            "means are compared with their errors). Give files with the columns "
            "quantity,mean,standard_error.",
            command.against.string(), command.estimates.string());
}

/// The results of one of two functions for each gate, from the file and the one that it is compared with: `of_trials`,
/// or `of_reports` where the header is that of means or shares.
template <class OfTrials, class OfReports>
auto on_estimates(const CheckCommand& command, const Spec& spec, const OfTrials& of_trials,
                  const OfReports& of_reports) {
    const std::string origin = command.estimates.string();
    std::string text = studies::read_text_file(command.estimates, studies::FileKind::estimates);
    if (!studies::gates::reports_means(text)) {
        expect_gates_on_trials(command, spec);
        const auto file = studies::gates::parse_estimates(text, origin);
        std::optional<studies::gates::EstimatesFile> against;
        if (!command.against.empty()) against = studies::gates::load_estimates_file(command.against);
        return each_on_estimates(spec, [&](const studies::gates::Gate& gate) {
            return of_trials(spec, gate, file, against ? &*against : nullptr);
        });
    }
    const auto file = studies::gates::parse_reported(text, origin, studies::gates::StandardErrors::required);
    text = {};  // a hundred megabytes, with a million bins
    std::optional<studies::gates::ReportedFile> against;
    if (!command.against.empty())
        against = studies::gates::load_reported(command.against, studies::gates::StandardErrors::optional);
    return each_on_estimates(spec, [&](const studies::gates::Gate& gate) {
        return of_reports(spec, gate, file, against ? &*against : nullptr);
    });
}

}  // namespace

void expect_estimates(const CheckCommand& command, const Spec& spec) {
    const auto& gates = spec.gates;
    const auto wanting =
        std::find_if(gates.begin(), gates.end(), [](const auto& gate) { return gate.from_estimates(); });
    const bool given = !command.estimates.empty();
    if (wanting != gates.end() && !given)
        throw UserError(
            "{}: gate \"{}\" is on estimates of another program (none are given). Add "
            "--estimates FILE.csv.",
            wanting->place, wanting->name);
    if (wanting == gates.end() && given)
        throw UserError(
            "--estimates {} (no gate of {} has a quantity, so none would be judged). Add a gate "
            "with quantity = \"...\", or leave the option out.",
            command.estimates.string(), command.bands.string());
    if (!given && !command.against.empty())
        throw UserError("--against (it is what --estimates FILE is compared with, and there is none). Add it.");
    if (given && command.seed_sweep > 0)
        throw UserError(
            "--estimates (the file has one set of random numbers; --seed-sweep runs new ones). Leave one of them out.");
    const auto of_ours = [](const studies::gates::Gate& gate) { return !gate.from_estimates(); };
    if (given && !command.save_baseline.empty() && std::any_of(gates.begin(), gates.end(), of_ours))
        throw UserError(
            "--save-baseline ({} has gates on estimates and gates that are run; a baseline is of "
            "one kind). Give them bands files of their own.",
            command.bands.string());
}

std::vector<studies::gates::GateResult> judge_file(const CheckCommand& command, const Spec& spec) {
    if (command.estimates.empty()) return {};
    return on_estimates(command, spec, studies::gates::judge_estimates, studies::gates::judge_reported);
}

std::vector<studies::gates::EstimatesPlan> plan_file(const CheckCommand& command, const Spec& spec) {
    if (command.estimates.empty()) return {};
    return on_estimates(command, spec, studies::gates::plan_estimates, studies::gates::plan_reported);
}

}  // namespace ff::app

#include "app/commands/check_estimates.hpp"

#include "core/support/error.hpp"
#include "studies/gates/at_gate.hpp"
#include "studies/gates/reported_gates.hpp"
#include "studies/readers/text_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace ff::app {
namespace {

using studies::GatesSpec;

/// What `make` makes of each gate on what another program gave; nothing is run for them.
template <class Make>
auto each_on_estimates(const GatesSpec& spec, const Make& make) {
    std::vector<decltype(make(spec.gates.front()))> results;
    for (const studies::Gate& gate : spec.gates) {
        if (gate.from_estimates()) results.push_back(studies::at_gate(gate, [&] { return make(gate); }));
    }
    return results;
}

/// @throws UserError where a gate needs means with their errors, and trials are given
void expect_gates_on_trials(const CheckCommand& command, const GatesSpec& spec) {
    for (const studies::Gate& gate : spec.gates) {
        const bool of_trials = gate.kind == studies::GateKind::bias || gate.kind == studies::GateKind::std;
        if (!gate.from_estimates() || (of_trials && gate.reference)) continue;
        throw UserError(
            fmt::format("{}: gate \"{}\" ({} is of trials, which are gated on bias and std beside a "
                        "reference). Give means with standard errors, or a number as reference.",
                        gate.place, gate.name, command.estimates.string()));
    }
}

}  // namespace

std::vector<studies::GateResult> judge_file(const CheckCommand& command, const GatesSpec& spec) {
    if (command.estimates.empty()) return {};
    const std::string origin = command.estimates.string();
    std::string text = studies::read_text_file(command.estimates, studies::FileKind::estimates);
    if (!studies::reports_means(text)) {
        if (!command.against.empty())
            throw UserError(
                fmt::format("--against {} ({} has trials; two files are compared by means with their errors). "
                            "Give files with the columns quantity,mean,standard_error.",
                            command.against.string(), origin));
        expect_gates_on_trials(command, spec);
        const auto file = studies::parse_estimates(text, origin);
        return each_on_estimates(spec, [&](const studies::Gate& gate) { return judge_estimates(spec, gate, file); });
    }
    const auto file = studies::parse_reported(text, origin, studies::Errors::required);
    text = {};  // a hundred megabytes, with a million bins
    std::optional<studies::ReportedFile> against;
    if (!command.against.empty()) against = studies::load_reported(command.against, studies::Errors::optional);
    return each_on_estimates(spec, [&](const studies::Gate& gate) {
        return judge_reported(spec, gate, file, against ? &*against : nullptr);
    });
}

std::vector<studies::EstimatesPlan> plan_file(const CheckCommand& command, const GatesSpec& spec) {
    if (command.estimates.empty()) return {};
    expect_gates_on_trials(command, spec);
    const auto file = studies::load_estimates_file(command.estimates);
    return each_on_estimates(spec, [&](const studies::Gate& gate) { return plan_estimates(spec, gate, file); });
}

}  // namespace ff::app

#include "reports/terminal/gates_plan.hpp"

#include "reports/terminal/gates_terminal.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

std::string trials_in_words(const studies::gates::Plan& plan) {
    const auto [least, most] = std::minmax_element(plan.trials.begin(), plan.trials.end());
    const std::string text = *least == *most ? fmt::format("{}", *most) : fmt::format("{}-{}", *least, *most);
    return plan.wanted_trials > 0 ? text + "!" : text;
}

}  // namespace

std::string gates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files,
                       std::span<const studies::gates::Plan> plans, unsigned threads) {
    std::string out = estimates_plan(spec, files);
    const std::size_t width = name_width(spec);
    double total = 0;
    double most = 0;
    bool capped = false;
    for (const studies::gates::Plan& plan : plans) {
        const studies::gates::Gate& gate = spec.gates[plan.gate];
        const double seconds = expected_seconds(plan);
        const double looks = plan.deterministic ? 1 : static_cast<double>(spec.looks);
        total += seconds;
        most += seconds * looks;
        capped = capped || plan.wanted_trials > 0;
        out += fmt::format("{:<{}}  {:<11}  {:>11}  {:>10}  {:>10}  {}\n", gate.name, width, name(gate.kind),
                           plan.effects.size(), trials_in_words(plan), seconds_in_words(seconds),
                           seconds_in_words(seconds * looks));
    }
    if (capped) out += fmt::format("! more are needed; max_trials allows {} a look\n", spec.max_trials);
    return out + fmt::format("\nabout {} on {} thread{}, at most {} ({} looks)\n", seconds_in_words(total / threads),
                             threads, threads == 1 ? "" : "s", seconds_in_words(most / threads), spec.looks);
}

}  // namespace ff::reports

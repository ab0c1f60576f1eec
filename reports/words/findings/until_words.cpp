#include "reports/words/findings/until_words.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {
namespace {

using studies::UntilFinding;

std::string stopping_rule_in_words(const studies::StudySpec& spec) {
    const studies::StoppingRule& rule = *spec.until;
    const std::string goal =
        rule.goal == studies::StoppingGoal::ci
            ? fmt::format("every pair's interval of level {:g} is at most ±{} wide", spec.level, brief(rule.target))
            : fmt::format("the RMSE of the mean over trials is at most {} on every pair", brief(rule.target));
    return fmt::format("Until {}: Stein's two stages, pilots of {} trials, at most {} trials.", goal, rule.pilot,
                       spec.trials);
}

/// The outcome for a cell of an adaptive study, e.g. "reached: 9.7e-06 with 412 trials".
std::string until_in_words(const studies::StudySpec& spec, const studies::UntilOutcome& outcome) {
    const std::string achieved = outcome.achieved
                                     ? fmt::format("{} with {} trials", brief(*outcome.achieved), outcome.trials)
                                     : fmt::format("{} trials", outcome.trials);
    switch (outcome.finding) {
        case UntilFinding::reached:
            return "reached: " + achieved;
        case UntilFinding::too_many_trials:
            return fmt::format("NOT reached: {}; it would take {}", achieved, outcome.wanted);
        case UntilFinding::infinite_variance:
            return fmt::format("NOT reached: {} pairs have infinite variance; {} on the others", outcome.unjudged,
                               achieved);
        case UntilFinding::too_few_hits:
            return fmt::format("NOT reached: {} pairs have too few hits in {} trials of the pilot", outcome.unjudged,
                               spec.until->pilot);
        case UntilFinding::no_spread:
            break;
    }
    return fmt::format("NOT reached: {} pairs have one value in all trials of the pilot", outcome.unjudged);
}

}  // namespace

std::vector<std::string> until_in_brief(const studies::StudyResults& results) {
    if (results.until.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> lines{stopping_rule_in_words(plan.spec)};
    const auto reached = std::count_if(results.until.begin(), results.until.end(),
                                       [](const auto& outcome) { return outcome.finding == UntilFinding::reached; });
    lines.push_back(fmt::format("Reached by {} of {} methods and sizes.", reached, results.until.size()));
    for (const studies::UntilOutcome& outcome : results.until) {
        lines.push_back(
            fmt::format("{}: {}", cell_label(plan, plan.cells[outcome.cell]), until_in_words(plan.spec, outcome)));
    }
    return lines;
}

}  // namespace ff::reports

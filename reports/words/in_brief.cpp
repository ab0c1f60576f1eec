#include "reports/words/in_brief.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/standing.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/diagnostics/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace ff::reports {

std::vector<std::string> heavy_tails_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> lines;
    for (const studies::CellAnalysis& found : results.findings.cells) {
        const auto of_cell = [&](const studies::HeavyTail& tail) { return tail.cell == found.cell; };
        const auto first = std::find_if(results.heavy_tails.begin(), results.heavy_tails.end(), of_cell);
        if (first == results.heavy_tails.end()) continue;
        const studies::Cell& cell = plan.cells[found.cell];
        lines.push_back(fmt::format(
            "WARNING {}: {} pairs look as if their variance were infinite (tail index {:.2f} for {}, 2 is the limit); "
            "their intervals and RMSE are not to be trusted.",
            cell_label(plan, cell), std::count_if(results.heavy_tails.begin(), results.heavy_tails.end(), of_cell),
            first->index, quantity_label(plan.scenes[cell.scene], first->pair)));
    }
    return lines;
}

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

using studies::VarianceReduction;

/// The size without the scene's or the method's name: two cells of one size are compared.
std::string scene_and_size(const studies::StudyPlan& plan, const studies::Cell& cell) {
    const std::string size = size_label(plan, cell);
    return plan.scenes.size() == 1 ? size : fmt::format("{}, {}", plan.scenes.name(cell.scene), size);
}

const studies::Method& method_of(const studies::StudyPlan& plan, const VarianceReduction& reduction) {
    return plan.spec.methods[plan.cells[reduction.cell].method];
}

/// The method that differs from one with a sequence per face only in having a sequence per patch; null: none.
const VarianceReduction* with_a_sequence_a_patch(const studies::StudyResults& results, const VarianceReduction& face) {
    const studies::StudyPlan& plan = results.findings.plan;
    const studies::Method& method = method_of(plan, face);
    if (method.allocation != Allocation::face) return nullptr;
    const auto found =
        std::find_if(results.reductions.begin(), results.reductions.end(), [&](const VarianceReduction& r) {
            const studies::Method& other = method_of(plan, r);
            return r.random_cell == face.random_cell && r.pair_class == face.pair_class &&
                   other.sampler == method.sampler && other.allocation == Allocation::patch;
        });
    return found == results.reductions.end() ? nullptr : &*found;
}

/// Whether the ladder of a cell has a larger size, which says the same again.
bool is_below_the_top(const studies::StudyResults& results, std::size_t cell) {
    return std::any_of(results.slopes.begin(), results.slopes.end(), [&](const studies::LadderSlopes& ladder) {
        const auto& cells = ladder.ladder.cells;
        return cells.back() != cell && std::find(cells.begin(), cells.end(), cell) != cells.end();
    });
}

/// Counts verdicts on rates, and names those that are not as expected.
std::string verdicts_in_words(const studies::StudyPlan& plan, const std::vector<studies::LadderSlopes>& ladders) {
    std::size_t judged = 0;
    std::size_t expected = 0;
    struct Others {
        std::vector<std::string> methods;
        double largest_p = 0;
    };
    std::map<std::pair<PairClass, bool>, Others> others;  // by class, and whether they are slower
    for (const studies::LadderSlopes& ladder : ladders) {
        const std::string in_scene =
            plan.scenes.size() == 1 ? std::string() : " in " + plan.scenes.name(ladder.ladder.scene);
        for (const studies::ClassSlopes& found : ladder.classes) {
            if (!found.adjusted_p) continue;
            ++judged;
            if (found.finding == studies::RateFinding::as_expected) {
                ++expected;
                continue;
            }
            Others& same = others[{found.pair_class, found.finding == studies::RateFinding::slower}];
            same.methods.push_back(ladder.ladder.label + in_scene);
            same.largest_p = std::max(same.largest_p, *found.adjusted_p);
        }
    }
    if (judged == 0) return {};
    std::string words = expected == judged && judged > 1
                            ? fmt::format("All {} rates that theory predicts are as expected", judged)
                            : fmt::format("Of {} that theory predicts, {} {} as expected", counted(judged, "rate"),
                                          expected, expected == 1 ? "is" : "are");
    for (const auto& [which, same] : others) {
        const bool one = same.methods.size() == 1;
        words +=
            fmt::format("; on {} pairs {} {} {} ({}{})", name(which.first), listed(same.methods), one ? "is" : "are",
                        which.second ? "slower" : "faster", one ? "" : "largest ", p_text(same.largest_p));
    }
    return words + ".";
}

/// One sentence for each ranking or, of many, how often each method comes first.
/// @param first  "Least variance"  @param cases  "comparisons with random points"
std::vector<std::string> rankings_in_brief(const std::vector<Ranking>& rankings, const studies::StudyPlan& plan,
                                           std::string_view first, std::string_view cases) {
    constexpr std::size_t most_sentences = 6;
    constexpr std::size_t most_methods = 4;
    std::vector<std::string> lines;
    if (rankings.size() <= most_sentences) {
        for (const Ranking& ranking : rankings) lines.push_back(sentence(ranking, plan));
        return lines;
    }
    std::map<std::string, int> times;
    for (const Ranking& ranking : rankings) {
        for (const std::string& leader : ranking.leaders) ++times[leader];
    }
    std::vector<std::pair<std::string, int>> leaders(times.begin(), times.end());
    std::ranges::stable_sort(leaders, std::ranges::greater(), &std::pair<std::string, int>::second);
    if (leaders.size() > most_methods) leaders.resize(most_methods);
    for (const auto& [method, count] : leaders) lines.push_back(fmt::format("{} in {}", listed({method}), count));
    return {fmt::format("{}, alone or with others, in {} {}: {}.", first, rankings.size(), cases,
                        lines.empty() ? "no method" : fmt::format("{}", fmt::join(lines, ", ")))};
}

/// Says which methods converge fastest and slowest on each class of pairs, as far as they can be distinguished, then
/// how many rates are as expected; empty without ladders.
std::vector<std::string> slopes_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> lines;
    if (results.occlusion.empty()) {  // otherwise scenes differ in what hides, and are described together
        lines = rankings_in_brief(rank_rates(results), results.findings.plan, "Fastest convergence",
                                  "scenes and classes of pairs");
    }
    if (std::string verdicts = verdicts_in_words(results.findings.plan, results.slopes); !verdicts.empty())
        lines.push_back(std::move(verdicts));
    return lines;
}

/// The constants of c/m in one sentence; empty without laws.
std::vector<std::string> error_laws_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> laws;
    if (!results.occlusion.empty()) return laws;  // its scenes are not about row sums
    for (const studies::ErrorLaw& law : results.error_laws) {
        if (!law.holds()) continue;
        laws.push_back(fmt::format("{:+.4f} for {}{} (within {} %)", law.first_order.coefficient, law.method,
                                   law.published ? " as printed" : "",
                                   brief(100 * law.first_order.largest_residual, 2)));
    }
    if (laws.empty()) return {};
    return {fmt::format("With m patches along an edge the row sums of deterministic methods miss 1 by c/m: c = {}.",
                        fmt::join(laws, ", "))};
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

std::vector<std::string> one_run_errors_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    double least = 1;
    double most = 0;
    std::size_t rows = 0;
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        const studies::Method& method = plan.spec.methods[plan.cells[row.cell].method];
        if (row.claimant != studies::Claimant::one_run || samplers::find(method.sampler).info.independent()) continue;
        ++rows;
        least = std::min(least, row.share());
        most = std::max(most, row.share());
    }
    if (rows == 0) return {};
    const double level = plan.spec.level;
    const std::string range =
        least == most ? fmt::format("{:.3g}", 100 * least) : fmt::format("{:.3g} to {:.3g}", 100 * least, 100 * most);
    return {fmt::format(
        "If the rays of a set are taken as independent, intervals of ±{:.3g} standard errors of one run hold "
        "the exact value in {} % of runs and pairs, not {:g} %.",
        stats::normal_critical((1 - level) / 2), range, 100 * level)};
}

std::string factor_text(const VarianceReduction& reduction) {
    return with_ends(reduction.factor, reduction.interval.low, reduction.interval.high);
}

std::vector<std::string> reductions_in_brief(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<std::string> lines;
    if (!results.occlusion.empty()) return lines;  // its scenes differ in what hides, and are described together
    std::vector<Ranking> rankings = rank_variances(results);
    std::erase_if(rankings, [&](const Ranking& ranking) { return is_below_the_top(results, *ranking.random_cell); });
    lines = rankings_in_brief(rankings, plan, "Least variance", "comparisons with random points");
    for (const VarianceReduction& face : results.reductions) {
        const VarianceReduction* patch = with_a_sequence_a_patch(results, face);
        if (patch == nullptr || plan.cells[face.cell].subdivision.m == 1) continue;
        const double gain = face.factor / patch->factor;
        const bool apart = face.interval.low > patch->interval.high || face.interval.high < patch->interval.low;
        lines.push_back(fmt::format(
            "One {} sequence over all patches of a face instead of one per patch {} the variance on {} pairs "
            "by {:.2f} at {}{}.",
            method_of(plan, face).sampler, gain >= 1 ? "divides" : "multiplies", name(face.pair_class),
            gain >= 1 ? gain : 1 / gain, scene_and_size(plan, plan.cells[face.cell]),
            apart ? "" : " (intervals overlap)"));
    }
    return lines;
}

std::vector<std::string> results_in_brief(const studies::StudyResults& results) {
    std::vector<std::string> all = main_finding(results).details;
    for (const auto& lines : {occlusion_in_brief(results), heavy_tails_in_brief(results), slopes_in_brief(results),
                              reductions_in_brief(results), coverage_in_brief(results), until_in_brief(results),
                              error_laws_in_brief(results)})
        all.insert(all.end(), lines.begin(), lines.end());
    return all;
}

}  // namespace ff::reports

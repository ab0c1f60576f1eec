#include "reports/words/findings/equal_cost.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "studies/comparison/contests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::Contest;
using studies::Ranked;

/// How many times the evaluations of the other one takes, over all faces: a ray serves all of them, a value of the
/// kernel one pair.
double times_the_cost(const studies::Analysis& findings, const Ranked& one, const Ranked& other) {
    const studies::StudyPlan& plan = findings.plan;
    const auto evaluations = [&](const Ranked& each) {
        const std::uint64_t in_trial =
            studies::evaluations_per_trial(plan, plan.cells[findings.cells[each.index].cell]);
        return static_cast<double>(std::max<std::uint64_t>(1, in_trial));
    };
    return evaluations(one) / evaluations(other);
}

/// Costs that differ by less count as equal.
constexpr double about_equal = 1.5;

/// The place of a method in a contest, 0 for those that are exact, then the entrants from 1 on.
std::optional<std::size_t> place_of(const studies::StudyPlan& plan, const Contest& contest, std::size_t method) {
    const auto is_its = [&](std::size_t cell) { return plan.cells[cell].method == method; };
    if (std::any_of(contest.exact.begin(), contest.exact.end(), is_its)) return 0;
    for (std::size_t i = 0; i < contest.entrants.size(); ++i) {
        if (is_its(contest.entrants[i].cell)) return i + 1;
    }
    return std::nullopt;
}

/// Whether what has the first place is shown to be better than what has the second.
bool is_better(const Contest& contest, std::size_t first, std::size_t second) {
    if (first == 0 || second == 0) return first == 0 && second > 0;
    return std::any_of(contest.handicaps.begin(), contest.handicaps.end(), [&](const studies::Handicap& handicap) {
        return handicap.better == first - 1 && handicap.worse == second - 1 && handicap.apart;
    });
}

/// The contest of a scene and class at equal evaluations that tells most; null where there is none.
const Contest* main_contest(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    for (const Contest* contest : studies::main_contests(results.contests, studies::Equal::evaluations)) {
        if (contest->scene == scene && contest->pair_class == pair_class) return contest;
    }
    return nullptr;
}

}  // namespace

std::string at_what_cost(const studies::Analysis& findings, const Ranked& first, const Ranked& second) {
    const double times = times_the_cost(findings, first, second);
    if (times > about_equal) return fmt::format(" with {} times more evaluations", brief(times));
    return times < 1 / about_equal ? fmt::format(" with {} times fewer evaluations", brief(1 / times)) : "";
}

std::string but_at_equal_cost(const studies::StudyResults& results, std::span<const Ranked> ranked, std::size_t scene,
                              PairClass pair_class) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    const Contest* const contest = main_contest(results, scene, pair_class);
    if (contest == nullptr) return {};
    const auto place = [&](const Ranked& one) {
        return place_of(plan, *contest, plan.cells[findings.cells[one.index].cell].method);
    };
    std::vector<Ranked> best;
    std::copy_if(ranked.begin(), ranked.end(), std::back_inserter(best),
                 [](const Ranked& one) { return one.group == 0; });
    // The rival that does best, and whether it is shown to be better than all that lead.
    std::optional<std::pair<std::size_t, const Ranked*>> rival;
    for (const Ranked& other : ranked) {
        const auto of_other = place(other);
        const bool speaks_against_all = of_other && std::all_of(best.begin(), best.end(), [&](const Ranked& leader) {
                                            const auto of_leader = place(leader);
                                            return of_leader && times_the_cost(findings, leader, other) > about_equal &&
                                                   !is_better(*contest, *of_leader, *of_other);
                                        });
        if (speaks_against_all && (!rival || *of_other < rival->first)) rival = {*of_other, &other};
    }
    if (!rival) return {};
    const auto name = [&](const Ranked& one) {
        return plan.spec.methods[plan.cells[findings.cells[one.index].cell].method].name;
    };
    const bool better = std::all_of(best.begin(), best.end(), [&](const Ranked& leader) {
        return is_better(*contest, rival->first, *place(leader));
    });
    if (better) return fmt::format("at equal evaluations {} errs less", listed({name(*rival->second)}));
    std::vector<std::string> leaders;
    for (const Ranked& leader : best) leaders.push_back(name(leader));
    return fmt::format("at equal evaluations {} {} not shown to err less than {}", listed(leaders),
                       leaders.size() == 1 ? "is" : "are", listed({name(*rival->second)}));
}

bool is_exact_at_all_sizes(const studies::Analysis& findings, const studies::Cell& cell, PairClass pair_class) {
    return std::none_of(findings.cells.begin(), findings.cells.end(), [&](const studies::CellAnalysis& found) {
        const studies::Cell& other = findings.plan.cells[found.cell];
        const studies::ClassError* error = found.class_error(pair_class);
        return other.method == cell.method && other.scene == cell.scene && error != nullptr &&
               error->rmse >= studies::rounding_error;
    });
}

std::string exact_name(const studies::Analysis& findings, std::size_t index, PairClass pair_class) {
    const studies::Cell& cell = findings.plan.cells[index];
    const std::string& name = findings.plan.spec.methods[cell.method].name;
    return is_exact_at_all_sizes(findings, cell, pair_class)
               ? name
               : fmt::format("{} ({})", name, size_label(findings.plan, cell));
}

std::string which_are_exact(const studies::StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::StudyPlan& plan = results.findings.plan;
    const Contest* const contest = main_contest(results, scene, pair_class);
    if (contest == nullptr || contest->exact.empty()) return {};
    std::vector<std::string> names;
    for (const std::size_t cell : contest->exact) names.push_back(exact_name(results.findings, cell, pair_class));
    std::string where = on_pairs(plan, scene, std::string(name(pair_class)));
    where.front() = 'O';
    return fmt::format("{} {} {} exact to rounding.", where, listed(names), names.size() == 1 ? "is" : "are");
}

}  // namespace ff::reports

#include "studies/comparison/decisions.hpp"

#include "core/exact/known_factors.hpp"
#include "core/visibility/occlusion.hpp"
#include "studies/trials/estimates.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ff::studies {
namespace {

void add_contest(const StudyPlan& plan, const Contest& contest, std::map<std::size_t, Choice>& choices) {
    std::set<std::size_t> counted;  // a method may enter with several numbers of patches: its best counts
    for (const std::size_t cell : contest.exact) {
        const std::size_t method = plan.cells[cell].method;
        counted.insert(method);
        Choice& choice = choices[method];
        choice.method = method;
        ++choice.entered;
        ++choice.best;
    }
    for (std::size_t i = 0; i < contest.entrants.size(); ++i) {
        const Entrant& entrant = contest.entrants[i];
        const std::size_t method = plan.cells[entrant.cell].method;
        if (!counted.insert(method).second) continue;
        Choice& choice = choices[method];
        choice.method = method;
        ++choice.entered;
        if (entrant.group == 0) ++choice.best;
        const double best = contest.exact.empty() ? contest.entrants.front().value : 0;
        choice.largest_handicap = std::max(choice.largest_handicap, entrant.value / best);
    }
}

}  // namespace

bool may_be_occluded(const Scene& scene, PairClass wanted) {
    const auto all = distinct_pairs(scene.faces.size(), Completion::direct);
    const auto pairs = pairs_of_class(scene, known_pairs(all, known_factors(scene)), wanted);
    return std::ranges::any_of(
        pairs, [&](const Quantity pair) { return ff::may_be_occluded(scene, pair.from - 1, pair.to - 1); });
}

std::vector<Decision> decide(const StudyPlan& plan, std::span<const Contest> contests, Equal equal) {
    if (plan.scenes.size() < 2) return {};
    std::map<std::pair<PairClass, bool>, std::pair<std::size_t, std::map<std::size_t, Choice>>> by_kind;
    for (const Contest* contest : main_contests(contests, equal)) {
        const bool occluded = may_be_occluded(plan.scenes[contest->scene], contest->pair_class);
        auto& [scenes, choices] = by_kind[{contest->pair_class, occluded}];
        ++scenes;
        add_contest(plan, *contest, choices);
    }
    std::vector<Decision> decisions;
    for (const auto& [kind, found] : by_kind) {
        const auto& [scenes, choices] = found;
        Decision& decision = decisions.emplace_back(Decision{kind.first, kind.second, equal, scenes, {}});
        for (const auto& [method, choice] : choices) decision.choices.push_back(choice);
        std::ranges::stable_sort(decision.choices, [](const Choice& a, const Choice& b) {
            return a.best != b.best ? a.best > b.best : a.largest_handicap < b.largest_handicap;
        });
    }
    return decisions;
}

}  // namespace ff::studies

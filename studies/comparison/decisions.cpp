#include "studies/comparison/decisions.hpp"

#include "core/exact/known_factors.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/occlusion.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/trials/estimates.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace ff::studies {
namespace {

std::set<std::size_t> methods_of(const StudyPlan& plan, std::size_t scene) {
    std::set<std::size_t> methods;
    for (const Cell& cell : plan.cells) {
        if (cell.scene == scene) methods.insert(cell.method);
    }
    return methods;
}

void add_contest(const StudyPlan& plan, const Contest& contest, std::map<std::size_t, Choice>& choices) {
    std::set<std::size_t> counted;  // a method may enter with several numbers of patches: its best counts
    for (const std::size_t cell : contest.exact) {
        const std::size_t method = plan.cells[cell].method;
        counted.insert(method);
        Choice& choice = choices[method];
        ++choice.entered;
        ++choice.best;
    }
    for (std::size_t i = 0; i < contest.entrants.size(); ++i) {
        const Entrant& entrant = contest.entrants[i];
        const std::size_t method = plan.cells[entrant.cell].method;
        if (!counted.insert(method).second) continue;
        Choice& choice = choices[method];
        ++choice.entered;
        if (entrant.group == 0) ++choice.best;
        const double best = contest.exact.empty() ? contest.entrants.front().value : 0;
        choice.largest_handicap = std::max(choice.largest_handicap, entrant.value / best);
    }
}

std::vector<Decision> decide_by(const StudyPlan& plan, std::span<const Contest* const> contests) {
    std::map<PairKind, std::pair<std::size_t, std::map<std::size_t, Choice>>> by_kind;
    for (const Contest* contest : contests) {
        auto& [cases, choices] = by_kind[pair_kind(plan.scenes[contest->scene], contest->pair_class)];
        ++cases;
        add_contest(plan, *contest, choices);
        for (const std::size_t method : methods_of(plan, contest->scene)) {
            choices[method].method = method;
            ++choices[method].ran;
        }
    }
    std::vector<Decision> decisions;
    for (const auto& [kind, found] : by_kind) {
        const auto& [cases, choices] = found;
        Decision& decision = decisions.emplace_back(Decision{kind, contests.front()->equal, cases, {}});
        for (const auto& [method, choice] : choices) decision.choices.push_back(choice);
        std::ranges::stable_sort(decision.choices, [](const Choice& a, const Choice& b) {
            if (a.best != b.best) return a.best > b.best;
            return a.ran != b.ran ? a.ran < b.ran : a.largest_handicap < b.largest_handicap;
        });
    }
    return decisions;
}

}  // namespace

PairKind pair_kind(const Scene& scene, PairClass pair_class) {
    constexpr double small = 0.02;
    const KnownFactors known = known_factors(scene);
    const auto all = distinct_pairs(scene.faces.size(), Completion::direct);
    const auto pairs = pairs_of_class(scene, known_pairs(all, known), pair_class);
    const bool adjacent = pair_class == PairClass::adjacent;
    const auto is_round = [&](const Surface& surface) {
        const auto ends_there = [&](const Quantity pair) {
            return surface.face == pair.from - 1 || surface.face == pair.to - 1;
        };
        return !is_polygon(surface.shape) && std::ranges::any_of(pairs, ends_there);
    };
    if (std::ranges::any_of(scene.surfaces, is_round)) return adjacent ? PairKind::curved_adjacent : PairKind::curved;
    const auto is_occluded = [&](const Quantity pair) { return may_be_occluded(scene, pair.from - 1, pair.to - 1); };
    if (std::ranges::any_of(pairs, is_occluded)) return adjacent ? PairKind::occluded_adjacent : PairKind::occluded;
    if (std::ranges::all_of(pairs, [&](const Quantity pair) { return *known.at(pair.from - 1, pair.to - 1) < small; }))
        return PairKind::small;
    return adjacent ? PairKind::adjacent : pair_class == PairClass::parallel ? PairKind::parallel : PairKind::other;
}

std::vector<std::size_t> most_often_best(const Decision& decision) {
    std::vector<std::size_t> methods;
    for (const Choice& choice : decision.choices) {
        if (choice.best > 0 && choice.best == decision.choices.front().best) methods.push_back(choice.method);
    }
    return methods;
}

std::vector<Decision> decide(const StudyPlan& plan, std::span<const Contest> contests, Equal equal) {
    if (plan.scenes.size() < 2) return {};
    return decide_by(plan, main_contests(contests, equal));
}

std::vector<TimedDecisions> decide_by_time(const StudyPlan& plan, std::span<const Contest> contests) {
    if (plan.scenes.size() < 2) return {};
    std::map<double, std::vector<const Contest*>> by_time;
    for (const Contest& contest : contests) {
        if (contest.equal == Equal::processor_time && contest.budget == round_time_from(contest.budget))
            by_time[contest.budget].push_back(&contest);
    }
    std::vector<TimedDecisions> all;
    for (const auto& [seconds, held] : by_time) all.push_back({seconds, decide_by(plan, held)});
    return all;
}

}  // namespace ff::studies

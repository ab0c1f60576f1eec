#include "reports/words/findings/choice_words.hpp"

#include "reports/text/labels.hpp"
#include "studies/analysis/configuration_estimates.hpp"
#include "studies/comparison/decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

namespace ff::reports {
namespace {

/// Kinds of pairs with the same methods become one.
void join(std::vector<BestOnKinds>& all, const BestOnKinds& more) {
    auto same = std::ranges::find(all, more.methods, &BestOnKinds::methods);
    if (same == all.end()) {
        all.push_back(more);
        return;
    }
    same->kinds.insert(same->kinds.end(), more.kinds.begin(), more.kinds.end());
    same->best += more.best;
    same->ran += more.ran;
}

/// Kinds with the most cases come first.
void sort_by_cases(std::vector<BestOnKinds>& all) {
    std::ranges::stable_sort(all, std::ranges::greater(), &BestOnKinds::ran);
}

/// For each kind, of the methods that are best the one that is best on the most cases of all kinds.
std::vector<BestOnKinds> one_for_each(const std::vector<BestOnKinds>& kinds) {
    std::map<std::string, std::size_t> cases;
    for (const BestOnKinds& taken : kinds) {
        for (const std::string& method : taken.methods) cases[method] += taken.best;
    }
    std::vector<BestOnKinds> all;
    for (BestOnKinds taken : kinds) {
        taken.methods = {*std::ranges::max_element(taken.methods, {}, [&](const auto& each) { return cases[each]; })};
        join(all, taken);
    }
    sort_by_cases(all);
    return all;
}

constexpr std::string_view at_equal_evaluations = "at equal evaluations take ";

std::vector<std::string> clauses_with_cases(std::vector<BestOnKinds> all) {
    sort_by_cases(all);
    std::vector<std::string> clauses;
    for (const BestOnKinds& taken : all) {
        const bool begins = clauses.empty();
        clauses.push_back(fmt::format("{}{} on {} pairs ({}{} of {}{})", begins ? at_equal_evaluations : "",
                                      listed(taken.methods, 3, "or"), listed(taken.kinds), begins ? "best in " : "",
                                      taken.best, taken.ran, begins ? " cases" : ""));
    }
    return clauses;
}

Ranking ranking_of(const studies::StudyPlan& plan, const studies::Decision& decision, const BestOnKinds& taken) {
    Ranking ranking{.heading = fmt::format("{} pairs", taken.kinds.front()), .leaders = taken.methods};
    constexpr std::size_t most_methods = 3;
    for (const studies::Choice& choice : decision.choices) {
        if (ranking.methods.size() == most_methods || choice.best == 0) break;
        ranking.methods.push_back({plan.spec.methods[choice.method].name, choice.method, "",
                                   static_cast<double>(choice.best) / static_cast<double>(choice.ran), std::nullopt,
                                   std::nullopt, fmt::format("{} of {}", choice.best, choice.ran)});
    }
    return ranking;
}

}  // namespace

std::vector<std::string> clauses_with_one_method(const std::vector<BestOnKinds>& kinds) {
    std::vector<std::string> clauses;
    std::size_t best = 0;
    std::size_t ran = 0;
    for (const BestOnKinds& taken : one_for_each(kinds)) {
        clauses.push_back(fmt::format("{}{} on {} pairs", clauses.empty() ? at_equal_evaluations : "",
                                      taken.methods.front(), listed(taken.kinds)));
        best += taken.best;
        ran += taken.ran;
    }
    if (!clauses.empty()) clauses.back() += fmt::format(": best in {} of {} cases", best, ran);
    return clauses;
}

BestChoices best_choices(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    if (results.slopes.empty() || studies::configuration_estimates(results.findings).empty()) return {};
    BestChoices found;
    std::vector<BestOnKinds> kinds;
    std::vector<BestOnKinds> joined;
    for (const studies::Decision& decision : studies::decide(plan, results.contests, studies::Equal::evaluations)) {
        if (decision.choices.empty()) continue;
        const studies::Choice& first = decision.choices.front();
        BestOnKinds taken{{}, {std::string(kind_in_words(decision.kind))}, first.best, first.ran};
        for (const studies::Choice& choice : decision.choices) {
            if (choice.best == first.best && choice.ran == first.ran)
                taken.methods.push_back(plan.spec.methods[choice.method].name);
        }
        found.rankings.push_back(ranking_of(plan, decision, taken));
        kinds.push_back(taken);
        join(joined, taken);
    }
    found.clauses = clauses_with_cases(joined);
    for (const std::size_t least_cases : {1U, 2U, 3U}) {
        std::erase_if(kinds, [&](const BestOnKinds& taken) { return taken.ran < least_cases; });
        if (!kinds.empty()) found.shorter.push_back(clauses_with_one_method(kinds));
    }
    return found;
}

}  // namespace ff::reports

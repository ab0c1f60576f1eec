#include "reports/words/findings/advice.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace ff::reports {
namespace {

/// The place of a method in all rankings together: the sum of how many are before it in each.
std::ptrdiff_t place_in(const std::vector<Ranking>& rankings, const std::string& label) {
    std::ptrdiff_t place = 0;
    for (const Ranking& ranking : rankings)
        place += std::ranges::find(ranking.methods, label, &RankedMethod::label) - ranking.methods.begin();
    return place;
}

/// The methods that are among the best in all rankings, by their places in them. A ranking that shows no method to be
/// better than another speaks against none.
std::vector<std::string> leaders_of_all(const std::vector<Ranking>& rankings) {
    std::vector<std::string> common;
    for (const RankedMethod& method : rankings.front().methods) common.push_back(method.label);
    for (const Ranking& ranking : rankings) {
        std::vector<std::string> best = ranking.leaders;
        if (best.empty()) {
            for (const RankedMethod& method : ranking.methods) best.push_back(method.label);
        }
        std::erase_if(
            common, [&](const std::string& label) { return std::find(best.begin(), best.end(), label) == best.end(); });
    }
    std::ranges::stable_sort(common, {}, [&](const std::string& label) { return place_in(rankings, label); });
    return common;
}

bool is_exact(const Ranking& ranking) {
    return !ranking.methods.front().value;
}

/// Of more methods than this one is named.
constexpr std::size_t most_named = 3;

/// One of several methods, with the number of those that are as good as it: "r_sequence (5 more are not shown to
/// differ)"; all of up to three.
std::string one_of(const std::vector<std::string>& labels) {
    if (labels.size() <= most_named) return listed(labels, most_named, "or");
    return fmt::format("{} ({} more are not shown to differ)", listed({labels.front()}), labels.size() - 1);
}

/// " at 4096 rays", where all methods have one size, without the only patch of a face.
std::string at_the_size(const std::vector<Ranking>& rankings) {
    std::string size = rankings.front().methods.front().size;
    for (const Ranking& ranking : rankings) {
        for (const RankedMethod& method : ranking.methods) {
            if (method.size != size) return {};
        }
    }
    constexpr std::string_view one_patch = "1 × ";
    if (size.starts_with(one_patch)) size.erase(0, one_patch.size());
    return size.empty() ? size : " at " + size;
}

/// "-0.72 to -0.58", the hull of the intervals of these methods; empty where one has no value.
std::string range_of(const std::vector<Ranking>& rankings, const std::vector<std::string>& labels,
                     std::string_view between) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Ranking& ranking : rankings) {
        for (const RankedMethod& method : ranking.methods) {
            if (std::find(labels.begin(), labels.end(), method.label) == labels.end()) continue;
            if (!method.value) return {};
            low = std::min(low, method.interval ? method.interval->low : *method.value);
            high = std::max(high, method.interval ? method.interval->high : *method.value);
        }
    }
    if (brief(low) == brief(high)) return brief(low);
    return fmt::format("{} {} {}", brief(low), between, brief(high));
}

/// "between -0.72 and -0.58"
std::string values_of(const std::vector<Ranking>& rankings, const std::vector<std::string>& labels) {
    const std::string range = range_of(rankings, labels, "and");
    return range.find(" and ") == std::string::npos ? range : "between " + range;
}

/// "on parallel and adjacent pairs", "on pairs of all scenes"
std::string where(const studies::StudyPlan& plan, const std::vector<Ranking>& rankings) {
    std::vector<std::string> classes;
    for (const Ranking& ranking : rankings) {
        if (ranking.scene != rankings.front().scene) return "on pairs of all scenes";
        std::string one(name(ranking.pair_class));
        if (std::find(classes.begin(), classes.end(), one) == classes.end()) classes.push_back(std::move(one));
    }
    return on_pairs(plan, rankings.front().scene, listed(std::move(classes)));
}

std::string nothing_better(const std::vector<Ranking>& rankings, const std::vector<std::string>& labels,
                           const Comparative& comparative) {
    if (std::all_of(rankings.begin(), rankings.end(), is_exact)) return "they are exact at the sizes compared";
    const std::string values = values_of(rankings, labels);
    return fmt::format("nothing is shown to {}{}", comparative.better,
                       values.empty()
                           ? std::string()
                           : fmt::format(" ({}{}{})", comparative.before_values, values, comparative.after_values));
}

/// The only method that is best in all rankings, with its margin in each.
std::vector<std::string> take_one(const studies::StudyPlan& plan, std::vector<Ranking> rankings,
                                  const std::string& leader) {
    const Ranking& first = rankings.front();
    for (Ranking& ranking : rankings) {
        const bool follows = &ranking != &first && !ranking.again.empty() && !first.again.empty() &&
                             ranking.methods[1].label == first.methods[1].label;
        ranking.brief = follows ? " " + ranking.again : " it " + ranking.margin;
    }
    auto clauses = clauses_of(plan, rankings, &Ranking::brief);
    clauses.front() = fmt::format("take {}{}: {}", listed({leader}), rankings.front().at, clauses.front());
    return clauses;
}

/// The same in fewer words, with the hull of its intervals; empty where one of them is not known.
std::vector<std::string> take_one_briefly(const studies::StudyPlan& plan, const std::vector<Ranking>& rankings,
                                          const std::string& leader) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const Ranking& ranking : rankings) {
        if (!ranking.ahead) return {};
        low = std::min(low, ranking.ahead->first);
        high = std::max(high, ranking.ahead->second);
    }
    return {fmt::format("take {}{}:{} it errs {} times less than the next {}", listed({leader}), rankings.front().at,
                        at_the_size(rankings), ends_in_words(low, high), where(plan, rankings))};
}

/// A clause for each ranking, since no method is best in all.
std::vector<std::string> each_by_itself(const studies::StudyPlan& plan, std::vector<Ranking> rankings,
                                        const Comparative& comparative, Words words) {
    for (Ranking& ranking : rankings) {
        if (words == Words::names_alone && ranking.but.empty() && !ranking.leaders.empty() &&
            ranking.methods.size() > 1 && !is_exact(ranking)) {
            ranking.brief = fmt::format("{} take {}", ranking.at, listed(ranking.leaders, 4, "or"));
        } else if (!ranking.but.empty() && words == Words::names_alone) {
            ranking.brief = fmt::format("{} {}", ranking.at, ranking.but);
        } else if (!ranking.but.empty() && ranking.leaders.size() != 1) {
            ranking.brief = fmt::format("{} nothing is shown to {} than {}, but {}", ranking.at, comparative.better,
                                        listed(ranking.leaders, 4, "or"), ranking.but);
        } else if (!ranking.but.empty()) {
            const std::string cost = words == Words::with_cost ? "" : ranking.cost;  // which the margin has
            ranking.brief = fmt::format("{} {} {}{}, but {}", ranking.at, listed(ranking.leaders), ranking.margin, cost,
                                        ranking.but);
        } else if (ranking.leaders.size() == 1) {
            ranking.brief = fmt::format("{} {} {}", ranking.at, listed(ranking.leaders), ranking.margin);
        } else if (ranking.leaders.empty()) {
            ranking.brief =
                fmt::format("{} no method is shown to {} than {}", ranking.at, comparative.better, comparative.than);
        } else {
            ranking.brief = fmt::format("{} take {}: {}", ranking.at, listed(ranking.leaders, 4, "or"),
                                        nothing_better({ranking}, ranking.leaders, comparative));
        }
    }
    // What is exact is no news: it comes last.
    std::stable_partition(rankings.begin(), rankings.end(), std::not_fn(is_exact));
    return clauses_of(plan, rankings, &Ranking::brief);
}

/// Methods that no other is shown to converge faster than, with their rates on each kind of pairs.
std::string fastest(const std::vector<Ranking>& rankings, const std::vector<std::string>& methods) {
    const auto named = methods.size() > most_named ? std::vector{methods.front()} : methods;
    std::vector<std::string> rates;
    for (const Ranking& ranking : rankings)
        rates.push_back(fmt::format("{}{} on {} pairs{}", rates.empty() ? "slope " : "",
                                    range_of({ranking}, named, "to"), name(ranking.pair_class), ranking.measured));
    return fmt::format("for the fastest convergence take {}: {}", one_of(methods), fmt::join(rates, ", "));
}

/// The advice on rankings in which the same is equal.
std::vector<std::string> advice_at(const studies::StudyPlan& plan, const std::vector<Ranking>& rankings,
                                   const Comparative& comparative, Words words) {
    const auto is_alone = [](const Ranking& ranking) { return ranking.methods.size() == 1; };
    const auto has_doubt = [](const Ranking& ranking) { return !ranking.but.empty(); };
    if (std::any_of(rankings.begin(), rankings.end(), is_alone) ||
        std::any_of(rankings.begin(), rankings.end(), has_doubt))
        return each_by_itself(plan, rankings, comparative, words);
    const auto shows_none = [](const Ranking& ranking) { return ranking.leaders.empty(); };
    if (std::all_of(rankings.begin(), rankings.end(), shows_none)) {
        return {fmt::format("{}{} no method is shown to {} than {}", where(plan, rankings), rankings.front().at,
                            comparative.better, comparative.than)};
    }
    const auto common = leaders_of_all(rankings);
    const auto has_one = [](const Ranking& ranking) { return ranking.leaders.size() == 1; };
    const bool one = std::all_of(rankings.begin(), rankings.end(), has_one);
    if (common.empty() || (one && !comparative.is_enough)) return each_by_itself(plan, rankings, comparative, words);
    if (one && words != Words::names_alone) return take_one(plan, rankings, common.front());
    if (auto clauses = one ? take_one_briefly(plan, rankings, common.front()) : std::vector<std::string>();
        !clauses.empty())
        return clauses;
    if (!comparative.is_enough) return {fastest(rankings, common)};
    return {fmt::format("take {}{}: {} {}", listed(common, 4, "or"), rankings.front().at, where(plan, rankings),
                        nothing_better(rankings, common, comparative))};
}

}  // namespace

std::vector<std::string> advice(const studies::StudyPlan& plan, std::vector<Ranking> rankings,
                                const Comparative& comparative, Words words) {
    for (Ranking& ranking : rankings) {
        if (words == Words::with_cost) ranking.margin += ranking.cost;
    }
    std::vector<std::vector<Ranking>> groups;
    for (const Ranking& ranking : rankings) {
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.front().at == ranking.at; });
        if (group == groups.end()) group = groups.insert(groups.end(), std::vector<Ranking>());
        group->push_back(ranking);
    }
    std::vector<std::string> clauses;
    for (const auto& group : groups) {
        for (std::string& clause : advice_at(plan, group, comparative, words)) clauses.push_back(std::move(clause));
    }
    return clauses;
}

std::vector<std::string> clauses_of(const studies::StudyPlan& plan, const std::vector<Ranking>& rankings,
                                    std::string Ranking::*said) {
    std::vector<std::string> clauses;
    for (auto first = rankings.begin(); first != rankings.end();) {
        std::vector<std::string> classes{std::string(name(first->pair_class))};
        auto next = std::next(first);
        for (; next != rankings.end() && next->scene == first->scene && (*next).*said == (*first).*said; ++next) {
            if (next->random_cell) break;
            classes.emplace_back(name(next->pair_class));
        }
        clauses.push_back(begin_on_pairs(plan, first->scene, listed(std::move(classes))) + (*first).*said);
        first = next;
    }
    return clauses;
}

}  // namespace ff::reports

#include "reports/words/findings/standing.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/equal_cost.hpp"
#include "reports/words/findings/letters.hpp"
#include "reports/words/findings/printed_errors.hpp"
#include "studies/comparison/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

using studies::Ranked;
using studies::StudyResults;

/// The methods that cannot be distinguished from the best.
struct Leaders {
    std::vector<std::string> names;
    double best = 0;
    double last = 0;   ///< the worst value among them
    bool all = false;  ///< whether all methods are among them

    [[nodiscard]] bool one() const { return names.size() == 1; }

    /// "a and b", "the 5 methods"
    [[nodiscard]] std::string everyone() const {
        return names.size() < 5 ? listed(names) : fmt::format("the {} methods", names.size());
    }
    /// Words for several leaders: "a and b have the smallest errors, with no difference shown between them".
    [[nodiscard]] std::string tied(std::string_view lead) const {
        return all ? fmt::format("no difference is shown between {}", everyone())
                   : fmt::format("{} {}, with no difference shown between them", listed(names), lead);
    }
};

/// @param methods  the same, in words
Leaders leaders(const std::vector<Ranked>& ranked, const std::vector<RankedMethod>& methods) {
    Leaders found;
    for (std::size_t i = 0; i < ranked.size(); ++i) {
        if (ranked[i].group > 0) continue;
        found.names.push_back(methods[i].label);
        found.last = ranked[i].value;
    }
    found.best = ranked.front().value;
    found.all = found.names.size() == ranked.size();
    return found;
}

std::vector<RankedMethod> ranked_cells(const studies::StudyPlan& plan, const std::vector<Ranked>& ranked) {
    std::vector<RankedMethod> methods;
    for (const Ranked& each : ranked) methods.push_back(ranked_cell(plan, each, letter(ranked, each)));
    return methods;
}

/// The same for methods with several sizes, which their names have to state.
Leaders leading_sizes(const studies::StudyPlan& plan, const std::vector<Ranked>& ranked) {
    auto methods = ranked_cells(plan, ranked);
    for (std::size_t i = 0; i < ranked.size(); ++i) methods[i].label = cell_label(plan, plan.cells[ranked[i].index]);
    return leaders(ranked, methods);
}

/// "-0.98 to -0.94", ends once where they are alike.
std::string from_to(const std::string& first, const std::string& last) {
    return first == last ? first : fmt::format("{} to {}", first, last);
}

std::string slope_and_reach(const Ranked& slope) {
    return with_half_width(slope.value, slope.interval->width() / 2);
}

/// The rankings of all classes of pairs of all scenes that have one, such that all of them hold together.
/// @param rank  fills one in, at a level
std::vector<Ranking> of_each_class(const StudyResults& results, void (*rank)(const StudyResults&, Ranking&, double)) {
    const studies::StudyPlan& plan = results.findings.plan;
    const double level = studies::level_of_each_class(results.findings);
    std::vector<Ranking> all;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : pair_classes) {
            Ranking ranking{heading_of(plan, scene, pair_class), {}, scene, pair_class};
            rank(results, ranking, level);
            if (!ranking.methods.empty()) all.push_back(std::move(ranking));
        }
    }
    return all;
}

void rank_rates_of_class(const StudyResults& results, Ranking& ranking, double level) {
    const auto ranked = studies::rank_slopes(results.slopes, ranking.scene, ranking.pair_class, level);
    if (ranked.slopes.empty()) return;
    if (ranked.of_median) ranking.measured = " (median error)";
    ranking.heading += ranking.measured;
    for (const Ranked& each : ranked.slopes) {
        const studies::LadderSlopes& ladder = results.slopes[each.index];
        const auto found = std::find_if(ladder.classes.begin(), ladder.classes.end(),
                                        [&](const auto& of) { return of.pair_class == ranking.pair_class; });
        const studies::Slope& slope = ranked.of_median ? found->median : found->rmse;
        ranking.methods.push_back({ladder.ladder.label, ladder.ladder.method, "", each.value, each.interval,
                                   slope.expected ? std::optional(slope.slowest_expected) : std::nullopt,
                                   letter(ranked.slopes, each)});
    }
    const Leaders best = leaders(ranked.slopes, ranking.methods);
    if (!best.all || best.one()) ranking.leaders = best.names;
    const Ranked& first = ranked.slopes.front();
    const Ranked& last = ranked.slopes.back();
    const std::string steepest =
        fmt::format("{} {}", ranked.of_median ? "slope of the median error" : "slope", slope_and_reach(first));
    if (ranked.slopes.size() == 1) {
        ranking.margin = "converges with " + steepest;
        ranking.said = fmt::format(" the error of {} falls with {}", listed(best.names), steepest);
    } else if (best.one()) {
        ranking.again = fmt::format("({})", steepest);
        ranking.margin = "converges fastest " + ranking.again;
        ranking.said = fmt::format(" {} {}", listed(best.names), ranking.margin);
    } else {
        ranking.said = fmt::format(" {} ({} {})", best.tied("converge fastest"),
                                   ranked.of_median ? "slopes of the median error" : "slopes",
                                   from_to(fmt::format("{:.2f}", best.best), fmt::format("{:.2f}", best.last)));
    }
    if (last.alone && !best.all)
        ranking.said += fmt::format("; {} slowest ({})", listed({ranking.methods.back().label}), slope_and_reach(last));
    // Errors of methods without an interval, such as deterministic ones, may fall faster or more slowly than these.
    const auto is_beyond = [&](const studies::LadderSlopes& ladder) {
        return ladder.ladder.scene == ranking.scene &&
               std::any_of(ladder.classes.begin(), ladder.classes.end(), [&](const auto& of) {
                   const auto& value = ranked.of_median ? of.median.slope : of.rmse.slope;
                   return of.pair_class == ranking.pair_class && value && (*value < first.value || *value > last.value);
               });
    };
    if (std::any_of(results.slopes.begin(), results.slopes.end(), is_beyond)) {
        ranking.said += "; methods without an interval are not ranked";
    }
    if (std::string exact = which_are_exact(results, ranking.scene, ranking.pair_class); !exact.empty())
        ranking.caveat = std::move(exact);
}

/// "2.1 to 2.4", how many times the error of the second is that of the first.
std::string times_smaller(const Ranked& first, const Ranked& second) {
    if (!second.behind) return brief(second.value / first.value);
    return ends_in_words(std::exp(second.behind->low), std::exp(second.behind->high));
}

/// Sets what is shown of the first: "errs 4.9 times less than PDM (4.6 to 5.2)", and at what cost.
void set_margin(const StudyResults& results, const Ranked& first, const Ranked& second, Ranking& ranking) {
    const studies::Analysis& findings = results.findings;
    const std::string times = fmt::format("{} times", brief(second.value / first.value));
    const std::string interval = second.behind ? fmt::format(" ({}{})", times_smaller(first, second),
                                                             as_printed(results, first, second, ranking.pair_class))
                                               : std::string();
    ranking.margin = fmt::format("errs {} less than {}{}", times, listed({ranking.methods[1].label}), interval);
    if (second.behind) ranking.ahead = {std::exp(second.behind->low), std::exp(second.behind->high)};
    ranking.cost = at_what_cost(findings, first, second);
    ranking.again = times + interval;
}

/// A sentence on errors that have no variance, which rankings do not compare; empty where there are none.
std::string which_variances_are_left_out(const studies::Analysis& findings, std::size_t scene) {
    const bool some = std::ranges::any_of(findings.cells, [&](const studies::CellAnalysis& found) {
        return findings.plan.cells[found.cell].scene == scene &&
               std::ranges::any_of(found.class_errors, [&](const studies::ClassError& error) {
                   return found.has_infinite_variance(error.pair_class);
               });
    });
    return some ? "Infinite variances are not compared." : "";
}

/// The same, or else on methods that have too few trials, or no size in common with those of a ranking of errors.
std::string which_errors_are_left_out(const studies::Analysis& findings, std::span<const std::size_t> compared,
                                      const Ranking& ranking) {
    if (std::string some = which_variances_are_left_out(findings, ranking.scene); !some.empty()) return some;
    const studies::StudyPlan& plan = findings.plan;
    std::set<std::size_t> left_out;
    for (const studies::CellAnalysis& found : findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        if (cell.scene != ranking.scene || found.class_error(ranking.pair_class) == nullptr) continue;
        if (studies::estimator_info(plan.spec.methods[cell.method]).exact || studies::may_be_luck(plan, cell)) continue;
        left_out.insert(cell.method);
    }
    for (const RankedMethod& method : ranking.methods) left_out.erase(method.method);
    if (left_out.empty()) return {};
    const auto has_common_size = [&](std::size_t cell) { return left_out.contains(plan.cells[cell].method); };
    return std::any_of(compared.begin(), compared.end(), has_common_size)
               ? "Methods with too few trials are not compared."
               : "Methods without a common size are not compared.";
}

void rank_errors_of_class(const StudyResults& results, Ranking& ranking, double level) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    // A publication with tables says which of its methods it compares.
    const auto tables = results.published ? results.published->comparisons : std::vector<studies::TableComparison>();
    const auto compared = studies::compared_cells(findings, ranking.scene, tables);
    const auto ranked = studies::rank_errors(findings, compared, ranking.pair_class, level);
    if (ranked.empty()) return;
    ranking.methods = ranked_cells(plan, ranked);
    if (tables.empty()) ranking.caveat = which_errors_are_left_out(findings, compared, ranking);
    const Leaders best = leaders(ranked, ranking.methods);
    if (!best.all || best.one()) ranking.leaders = best.names;
    const std::string& size = ranking.methods.front().size;
    const bool of_one_size = std::all_of(ranking.methods.begin(), ranking.methods.end(),
                                         [&](const RankedMethod& each) { return each.size == size; });
    const std::string rmse = fmt::format("RMSE {}{}", from_to(brief(best.best), brief(best.last)),
                                         of_one_size || best.one() ? ", " + size : "");
    if (best.best < studies::rounding_error) {
        std::vector<std::string> exact;
        for (const Ranked& each : ranked) {
            if (each.group == 0)
                exact.push_back(exact_name(findings, findings.cells[each.index].cell, ranking.pair_class));
        }
        ranking.margin =
            is_exact_at_all_sizes(findings, plan.cells[findings.cells[ranked.front().index].cell], ranking.pair_class)
                ? "is exact"
                : fmt::format("is exact with {} evaluations per face",
                              findings.cells[ranked.front().index].evaluations_per_face);
        ranking.said = fmt::format(" {} {} exact to rounding", listed(std::move(exact)), best.one() ? "is" : "are");
    } else if (ranked.size() == 1) {
        const auto& interval = ranked.front().interval;
        ranking.margin = fmt::format(
            "has an RMSE of {}{} at {}", brief(best.best),
            interval ? fmt::format(" ({} to {})", brief(interval->low), brief(interval->high)) : std::string(), size);
        ranking.said = fmt::format(" {} {}", listed(best.names), ranking.margin);
    } else if (best.one()) {
        set_margin(results, ranked[0], ranked[1], ranking);
        ranking.said = fmt::format(" {} has the smallest error{}, {} times smaller than {} ({})", listed(best.names),
                                   tables.empty() ? "" : " of the published methods",
                                   times_smaller(ranked[0], ranked[1]), listed({ranking.methods[1].label}), rmse);
    } else {
        ranking.said = fmt::format(" {} ({})", best.tied("have the smallest errors"), rmse);
    }
    if (best.best < studies::rounding_error || !tables.empty()) return;
    ranking.but = but_at_equal_cost(results, ranked, ranking.scene, ranking.pair_class);
    if (!ranking.but.empty()) ranking.said += "; " + ranking.but;
}

void rank_variances_of_size(const StudyResults& results, Ranking& ranking, double level) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto ranked =
        studies::rank_reductions(results.findings, results.reductions, *ranking.random_cell, ranking.pair_class, level);
    ranking.methods = ranked_cells(plan, ranked);
    for (RankedMethod& each : ranking.methods) each.expected = 1;
    const bool random_leads = std::any_of(ranked.begin(), ranked.end(), [&](const Ranked& each) {
        return each.index == ranking.random_cell && each.group == 0;
    });
    ranking.caveat = which_are_exact(results, ranking.scene, ranking.pair_class);
    if (ranking.caveat.empty()) ranking.caveat = which_variances_are_left_out(results.findings, ranking.scene);
    const std::string size = size_label(plan, plan.cells[*ranking.random_cell]);
    ranking.heading += ", " + size;
    ranking.at = fmt::format(" with {}", size);
    ranking.said = ranking.at + " ";
    const Leaders best = leaders(ranked, ranking.methods);
    if (best.all) {
        ranking.said += fmt::format("no difference is shown between the variances of {}", best.everyone());
    } else if (random_leads) {
        ranking.said += "no method is shown to have less variance than random points";
    } else {
        const auto& interval = ranked.front().interval;
        const std::string much = best.one() && interval ? fmt::format("{} ({} to {})", brief(best.best),
                                                                      brief(interval->low), brief(interval->high))
                                                        : from_to(brief(best.last), brief(best.best));
        ranking.leaders = best.names;
        ranking.margin = fmt::format("varies {} times less than random points", much);
        ranking.said += fmt::format(
            "{}, {} times less than random points",
            best.one() ? listed(best.names) + " has the least variance" : best.tied("have the least variance"), much);
        std::vector<std::string> unshown;
        for (const RankedMethod& each : ranking.methods) {
            const bool leads = std::ranges::find(best.names, each.label) != best.names.end();
            if (leads && each.interval && each.interval->low <= 1) unshown.push_back(each.label);
        }
        if (!unshown.empty()) ranking.said += fmt::format("; this is not shown for {}", listed(unshown));
    }
}

}  // namespace

std::string sentence(const Ranking& ranking, const studies::StudyPlan& plan) {
    return fmt::format("O{}{}.", begin_on_pairs(plan, ranking.scene, name(ranking.pair_class)).substr(1), ranking.said);
}

std::vector<Ranking> rank_rates(const StudyResults& results) {
    return of_each_class(results, rank_rates_of_class);
}

std::vector<Ranking> rank_compared_errors(const StudyResults& results) {
    return of_each_class(results, rank_errors_of_class);
}

std::vector<Ranking> rank_variances(const StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::vector<Ranking> all;
    std::set<std::pair<std::size_t, PairClass>> seen;
    for (const studies::VarianceReduction& first : results.reductions) {
        if (!seen.emplace(first.random_cell, first.pair_class).second) continue;
        const std::size_t scene = plan.cells[first.random_cell].scene;
        all.push_back({.heading = heading_of(plan, scene, first.pair_class),
                       .scene = scene,
                       .pair_class = first.pair_class,
                       .random_cell = first.random_cell});
    }
    // The largest sizes first, which tell most.
    std::ranges::stable_sort(all, std::ranges::greater(), [&](const Ranking& ranking) {
        return studies::evaluations_per_trial(plan, plan.cells[*ranking.random_cell]);
    });
    const double level = studies::level_of_each(plan.spec.level, all.size());
    for (Ranking& ranking : all) rank_variances_of_size(results, ranking, level);
    return all;
}

RankedMethod ranked_cell(const studies::StudyPlan& plan, const Ranked& one, std::string group) {
    const studies::Cell& cell = plan.cells[one.index];
    return {plan.spec.methods[cell.method].name,
            cell.method,
            size_label(plan, cell),
            one.value < studies::rounding_error ? std::nullopt : std::optional(one.value),
            one.interval,
            std::nullopt,
            std::move(group)};
}

std::string smallest_errors(const studies::Analysis& findings, std::span<const std::size_t> cells,
                            PairClass pair_class) {
    const auto ranked = studies::rank_errors(findings, cells, pair_class, studies::level_of_each_class(findings));
    if (ranked.empty()) return {};
    const Leaders best = leading_sizes(findings.plan, ranked);
    return fmt::format(
        "{} {} (RMSE {})", listed(best.names),
        best.one() ? "has the smallest error" : "have the smallest errors, with no difference shown between them",
        from_to(brief(best.best), brief(best.last)));
}

std::string largest_efficiencies(const studies::Analysis& findings, std::span<const std::size_t> cells,
                                 PairClass pair_class) {
    const auto ranked = studies::rank_efforts(findings, cells, pair_class);
    if (ranked.size() < 2) return {};
    const Leaders best = leading_sizes(findings.plan, ranked);
    if (best.all) return fmt::format("no difference is shown between the {}", ranked.size());
    return fmt::format("{} {} most; the estimates of all {} span a factor of {}", listed(best.names),
                       best.one() ? "achieves" : "achieve", ranked.size(), brief(ranked.back().value / best.best));
}

}  // namespace ff::reports

#include "reports/words/standing.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/comparison/rivals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <vector>

namespace ff::reports {
namespace {

using studies::Ranked;

const std::string& method_name(const studies::StudyPlan& plan, std::size_t cell) {
    return plan.spec.methods[plan.cells[cell].method].name;
}

/// Those that cannot be told apart from the best.
std::vector<Ranked> leaders(const std::vector<Ranked>& ranked) {
    std::vector<Ranked> best;
    std::copy_if(ranked.begin(), ranked.end(), std::back_inserter(best),
                 [](const Ranked& each) { return each.group == 0; });
    return best;
}

std::vector<std::string> cell_labels(const studies::StudyPlan& plan, const std::vector<Ranked>& ranked) {
    std::vector<std::string> labels;
    for (const Ranked& each : ranked) labels.push_back(cell_label(plan, plan.cells[each.index]));
    return labels;
}

/// "-0.98 to -0.94", ends once where they are alike.
std::string from_to(const std::string& first, const std::string& last) {
    return first == last ? first : fmt::format("{} to {}", first, last);
}

std::string slope_and_reach(const Ranked& slope) {
    return fmt::format("{:.2f} ± {:.2f}", slope.value, slope.interval->width() / 2);
}

}  // namespace

using studies::StudyResults;

std::string sentence(std::string clause) {
    clause.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(clause.front())));
    return clause + ".";
}

std::string rate_clause(const StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto ranked = studies::rank_slopes(results.slopes, scene, pair_class, plan.spec.level);
    if (ranked.slopes.empty()) return {};
    const std::string where = on_pairs(plan, scene, pair_class);
    const std::string slope = ranked.of_median ? "slope of the median error" : "slope";
    const auto label = [&](const Ranked& each) { return results.slopes[each.index].ladder.label; };
    const Ranked& first = ranked.slopes.front();
    const Ranked& last = ranked.slopes.back();
    if (ranked.slopes.size() == 1)
        return fmt::format("{} the error of {} falls with {} {}", where, label(first), slope, slope_and_reach(first));
    const auto best = leaders(ranked.slopes);
    std::string text;
    if (best.size() == 1) {
        text = fmt::format("{} {} converges fastest ({} {})", where, label(first), slope, slope_and_reach(first));
    } else {
        std::vector<std::string> names;
        for (const Ranked& each : best) names.push_back(label(each));
        text = fmt::format("{} {} cannot be told apart ({} {})", where,
                           best.size() == ranked.slopes.size() ? fmt::format("all {} methods", best.size())
                                                               : listed(names) + " converge fastest and",
                           ranked.of_median ? "slopes of the median error" : "slopes",
                           from_to(fmt::format("{:.2f}", first.value), fmt::format("{:.2f}", best.back().value)));
    }
    if (last.alone && best.size() < ranked.slopes.size())
        text += fmt::format("; {} slowest ({})", label(last), slope_and_reach(last));
    return text;
}

std::string error_clause(const StudyResults& results, std::size_t scene, PairClass pair_class) {
    const studies::Findings& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    const auto tables = results.published ? results.published->comparisons : std::vector<studies::TableComparison>();
    const auto ranked = studies::rank_errors(findings, studies::compared_cells(findings, scene, tables), pair_class);
    if (ranked.empty()) return {};
    const std::string where = on_pairs(plan, scene, pair_class);
    const auto best = leaders(ranked);
    const Ranked& first = ranked.front();
    const std::string size = size_label(plan, plan.cells[first.index]);
    std::vector<std::string> names;
    for (const Ranked& each : best) names.push_back(method_name(plan, each.index));
    if (first.value < studies::rounding_error)
        return fmt::format("{} {} {} exact to rounding", where, listed(names), names.size() == 1 ? "is" : "are");
    if (ranked.size() == 1)
        return fmt::format("{} {} has an RMSE of {} at {}", where, names.front(), brief(first.value), size);
    if (best.size() > 1) {
        return fmt::format("{} {} cannot be told apart (RMSE {}, {})", where,
                           best.size() == ranked.size() ? fmt::format("all {} methods", best.size())
                                                        : listed(names) + " have the smallest errors and",
                           from_to(brief(first.value), brief(best.back().value)), size);
    }
    const Ranked& next = ranked[1];
    const auto& better = *findings.cells[first.index].class_error(pair_class);
    const auto& worse = *findings.cells[next.index].class_error(pair_class);
    const auto pairs = static_cast<double>(ranked.size() * (ranked.size() - 1)) / 2;
    const auto log_of = [&](const Ranked& each, const studies::ClassError& error) {
        return *log_rmse(error, plan.cells[each.index].deterministic);
    };
    const auto ratio =
        studies::ratio_interval(log_of(first, better), log_of(next, worse), 1 - (1 - plan.spec.level) / pairs);
    std::string times = brief(next.value / first.value);
    if (ratio) {
        times = std::isfinite(ratio->high) ? from_to(brief(ratio->low), brief(ratio->high))
                                           : fmt::format("at least {}", brief(ratio->low));
    }
    return fmt::format("{} {} has the smallest error, {} times smaller than {} (RMSE {}, {})", where, names.front(),
                       times, method_name(plan, next.index), brief(first.value), size);
}

std::string smallest_errors(const studies::Findings& findings, std::span<const std::size_t> cells,
                            PairClass pair_class) {
    const auto ranked = studies::rank_errors(findings, cells, pair_class);
    if (ranked.empty()) return {};
    const auto best = leaders(ranked);
    return fmt::format(
        "{} {} (RMSE {})", listed(cell_labels(findings.plan, best)),
        best.size() == 1 ? "has the smallest error" : "have the smallest errors and cannot be told apart",
        from_to(brief(best.front().value), brief(best.back().value)));
}

std::string largest_efficiencies(const studies::Findings& findings, std::span<const std::size_t> cells,
                                 PairClass pair_class) {
    const auto ranked = studies::rank_efforts(findings, cells, pair_class);
    if (ranked.size() < 2) return {};
    const auto best = leaders(ranked);
    if (best.size() == ranked.size()) return fmt::format("all {} cannot be told apart", best.size());
    return fmt::format("{} {} most; the estimates of all {} span a factor of {}",
                       listed(cell_labels(findings.plan, best)), best.size() == 1 ? "achieves" : "achieve",
                       ranked.size(), brief(ranked.back().value / best.front().value));
}

std::string variance_clause(const StudyResults& results, std::size_t random_cell, PairClass pair_class) {
    const studies::Findings& findings = results.findings;
    const auto ranked = studies::rank_reductions(findings, results.reductions, random_cell, pair_class);
    if (ranked.empty()) return {};
    const auto best = leaders(ranked);
    std::vector<std::string> names;
    for (const Ranked& leader : best) names.push_back(method_name(findings.plan, leader.index));
    const studies::Cell& cell = findings.plan.cells[random_cell];
    const std::string place =
        fmt::format("{} with {}", on_pairs(findings.plan, cell.scene, pair_class), size_label(findings.plan, cell));
    if (best.size() == ranked.size())
        return fmt::format("{} the variances of all {} methods cannot be told apart", place, best.size());
    if (std::any_of(best.begin(), best.end(), [&](const Ranked& leader) { return leader.index == random_cell; }))
        return fmt::format("{} no method is shown to have less variance than random points", place);
    const auto& interval = best.front().interval;
    const std::string much =
        best.size() > 1 || !interval
            ? from_to(fmt::format("{:.3g}", best.back().value), fmt::format("{:.3g}", best.front().value))
            : fmt::format("{:.3g} ({:.3g} to {:.3g})", best.front().value, interval->low, interval->high);
    return fmt::format("{} {} {} the least variance, {} times less than random points", place, listed(names),
                       best.size() == 1 ? "has" : "have", much);
}

}  // namespace ff::reports

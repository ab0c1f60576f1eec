#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/in_brief.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/diagnostics/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

TableCell answer(const stats::Interval& interval) {
    if (interval.low > 0) return {"yes", Mark::good};
    if (interval.high < 0) return {"the other way round", Mark::bad};
    return {"not shown", Mark::open};
}

std::string_view in_words(studies::Claimant claimant) {
    switch (claimant) {
        case studies::Claimant::estimator:
            return "of the estimator";
        case studies::Claimant::study:
            return "claimed_error";
        case studies::Claimant::one_run:
            break;
    }
    return "rays taken as random";
}

/// The ratio is infinite where the claimed error is 0.
std::string times_claimed(double ratio) {
    return std::isfinite(ratio) ? fmt::format("{:.2g}", ratio) : "infinite";
}

}  // namespace

Table error_law_table(const studies::StudyResults& results) {
    Table table{
        "error-law", "How the error of the deterministic methods falls",
        fmt::format("Closure error (mean row sum − 1) with m patches along an edge, fitted by c/m, with no c where "
                    "an error is further than {:g} % from it; the exponent fitted freely beside it.",
                    100 * studies::ErrorLaw::most_misfit),
        columns({"method", ">c", ">largest residual of c/m", ">~free exponent", "~m", "~closure error"})};
    for (const studies::ErrorLaw& law : results.error_laws) {
        std::vector<std::string> errors;
        for (const double error : law.closure_errors) errors.push_back(fmt::format("{:+.6f}", error));
        table.rows.push_back({law.method + (law.published ? ", as printed" : ""),
                              law.holds() ? fmt::format("{:+.4f}", law.first_order.coefficient) : "–",
                              brief(100 * law.first_order.largest_residual, 2) + " %",
                              law.free ? fmt::format("{:.4f}", law.free->exponent) : "–",
                              fmt::format("{}", fmt::join(law.m, ", ")), fmt::format("{}", fmt::join(errors, ", "))});
    }
    for (const studies::ErrorLaw& printed : results.error_laws) {
        if (!printed.published) continue;
        for (const studies::ErrorLaw& ours : results.error_laws) {
            if (ours.published || ours.method != printed.method || !ours.holds() || !printed.holds()) continue;
            const double ratio = ours.first_order.coefficient / printed.first_order.coefficient;
            if (std::abs(ratio - 1) < 0.01) continue;
            table.remarks.push_back(fmt::format(
                "The printed {} figures follow the same kind of law with another constant: c is {:.2f} times as "
                "large here. The method as the paper describes it does not give the paper's figures; nothing was "
                "tuned to make it so.",
                printed.method, ratio));
        }
    }
    return without_idle_columns(std::move(table));
}

Table reductions_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"reductions", "Variance against random points",
                fmt::format("How many times less variance than the method with sampler random and the same scene, "
                            "estimator, completion and size, on the pairs of a class together; intervals of level "
                            "{:g} allow for the spread of both over trials. As many points for both: the factor is "
                            "also that of the efficiency per point.",
                            plan.spec.level),
                columns({"method", "pairs", ">times less variance", "~size", "~allocation"})};
    std::vector<studies::VarianceReduction> largest_first = results.reductions;
    std::ranges::stable_sort(largest_first, std::ranges::greater(), &studies::VarianceReduction::factor);
    for (const studies::VarianceReduction& reduction : largest_first) {
        const studies::Cell& cell = plan.cells[reduction.cell];
        const studies::Method& method = plan.spec.methods[cell.method];
        const bool shoots = estimator_info(method).observes == Observes::hits;
        table.rows.push_back({method_label(plan, cell), name(reduction.pair_class), factor_text(reduction),
                              size_label(plan, cell), shoots ? std::string(studies::name(method.allocation)) : "–"});
    }
    return without_idle_columns(std::move(table));
}

Table coverage_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "coverage", "How often intervals cover",
        fmt::format(
            "The trials of each method are cut into groups of R, each of which gives one interval of level {0:g} for "
            "each of some pairs that share no points; the share of intervals that contain the exact value, with its "
            "own Clopper-Pearson interval. Stopping rules begin with R trials and aim at the half-width that 4 R have "
            "on average. Marked: significantly short of {0:g} (Šidák over all rows, {1:g} % together).",
            plan.spec.level, 100 * (1 - plan.spec.level)),
        columns(
            {"method", "~pairs", "interval", ">R", ">coverage", "~remark", ">~mean trials", ">~intervals", "~size"})};
    for (const studies::Coverage& row : results.coverage) {
        const studies::Cell& cell = plan.cells[row.cell];
        const bool infinite = results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
        table.rows.push_back({method_label(plan, cell),
                              name(row.pair_class),
                              rule_in_words(row.interval_method),
                              std::to_string(row.replicates),
                              {fmt::format("{:.4f} [{:.4f}, {:.4f}]", row.share(), row.coverage_interval.low,
                                           row.coverage_interval.high),
                               row.short_of_nominal ? Mark::bad : Mark::none},
                              infinite ? "infinite variance" : "",
                              fmt::format("{:.1f}", row.mean_trials),
                              std::to_string(row.intervals),
                              size_label(plan, cell)});
    }
    return without_idle_columns(std::move(table));
}

Table least_coverage_table(const studies::StudyResults& results) {
    Table table{"least-coverage", "Least coverage of each rule",
                fmt::format("Over all methods and pairs whose variance is finite: the smallest share of intervals of "
                            "level {0:g} that contain the exact value, with its own Clopper-Pearson interval. Marked: "
                            "significantly short of {0:g}.",
                            results.findings.plan.spec.level),
                columns({"interval", ">R", ">least coverage", "~method"})};
    for (const Ranking& rule : least_coverage(results)) {
        for (const RankedMethod& least : rule.methods) {
            const bool is_short = least.group.ends_with('*');
            table.rows.push_back(
                {rule.heading,
                 least.label.substr(least.label.rfind(' ') + 1),
                 {fmt::format("{:.4f} [{:.4f}, {:.4f}]", *least.value, least.interval->low, least.interval->high),
                  is_short ? Mark::bad : Mark::none},
                 least.group});
        }
    }
    return table;
}

Table spreads_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"spreads", "The sampled spread against the exact one",
                "With n independent rays from each of P patches Var F = (1/P²) Σ F_p (1 − F_p) / n, from exact "
                "patch-to-face factors; row sums likewise. Two-sided χ² tests of every pair and row sum; p adjusted by "
                "Holm over these and by Šidák over methods and sizes.",
                columns({"method and size", "verdict", ">sampled / exact standard deviation", ">~smallest adjusted p",
                         ">~quantities"})};
    for (const studies::VarianceCheck& check : results.variance_checks) {
        const bool differs = check.adjusted_p < 1 - plan.spec.level;
        table.rows.push_back({cell_label(plan, plan.cells[check.cell]),
                              {differs ? "differs" : "agrees", differs ? Mark::bad : Mark::good},
                              fmt::format("{:.3f} to {:.3f}", check.smallest_ratio, check.largest_ratio),
                              p_value(check.adjusted_p),
                              std::to_string(check.quantities.size())});
    }
    return table;
}

Table evenness_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "evenness", "Do measures of evenness predict the errors?",
        fmt::format("Kendall's rank correlation, over samplers of equal size, of a measure of how unevenly a "
                    "set of points is spread (mean of a few sets) and the RMSE that it makes; with its "
                    "interval of level {:g} [kendall1970]. 1: the same order. Samplers are not a random sample, "
                    "and errors are measured with noise, which lowers the correlation.",
                    plan.spec.level),
        columns({"~scene", ">samples", "pairs", "measure", ">~samplers", ">correlation", ">~interval",
                 "predicts the order"})};
    for (const studies::Evenness& found : results.evenness) {
        const studies::Cell& cell = plan.cells[found.cell];
        const auto& [tau, interval] = found.correlation;
        table.rows.push_back(
            {{fmt::format("{}, {}", plan.scenes.name(cell.scene), plan.spec.methods[cell.method].estimator)},
             {fmt::format("{}", cell.samples_per_patch)},
             {std::string(name(found.pair_class))},
             {std::string(found.measure)},
             {fmt::format("{}", found.methods)},
             {fmt::format("{:.2f}", tau)},
             {fmt::format("[{:.2f}, {:.2f}]", interval.low, interval.high)},
             answer(interval)});
    }
    return table;
}

Table claimed_errors_table(const studies::StudyResults& results, Claims claims) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "claimed-errors", "How often errors are within the claimed ones",
        fmt::format("Share of pairs and runs whose error is at most what is claimed; on the pair where it holds "
                    "least, of how many runs, with the interval of that share (Clopper-Pearson, {0:g} over "
                    "the pairs together). A claim about rays taken as random is {1:.3g} binomial standard "
                    "errors of one run, and should hold in a share of {0:g}; others always, or in the share that the "
                    "study says. Last, the median "
                    "and the largest error, in units of what is claimed (infinite "
                    "where that is 0).",
                    plan.spec.level, stats::normal_critical((1 - plan.spec.level) / 2)),
        columns({"method and size", "pairs", "verdict", ">holds", ">~should hold", "~claim", "~on the worst pair",
                 "~errors / claim"})};
    std::vector<const studies::ClaimedErrors*> rows;
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        if (claims == Claims::all || row.claimant != studies::Claimant::one_run) rows.push_back(&row);
    }
    // Where many claims hold, it is enough to say how many.
    constexpr std::size_t most_rows = 12;
    std::size_t hidden = 0;
    if (claims == Claims::stated && rows.size() > most_rows)
        hidden =
            std::erase_if(rows, [](const auto* row) { return row->finding == studies::ClaimedErrorFinding::holds; });
    if (hidden > 0) {
        table.remarks.push_back(
            fmt::format("{} methods, sizes and classes of pairs whose claims hold: claimed_errors.csv.", hidden));
    }
    for (const studies::ClaimedErrors* const found : rows) {
        const studies::ClaimedErrors& row = *found;
        const studies::Cell& cell = plan.cells[row.cell];
        const std::uint64_t trials = cell.trials;
        const bool fails = row.finding == studies::ClaimedErrorFinding::fails;
        table.rows.push_back({cell_label(plan, cell),
                              name(row.pair_class),
                              {fails ? "fails" : "not refuted", fails ? Mark::bad : Mark::good},
                              fmt::format("{:.4g} %", 100 * row.share()),
                              row.promised < 1 ? fmt::format("{:.4g} %", 100 * row.promised) : "always",
                              in_words(row.claimant),
                              trials == 1 ? std::string("–")
                                          : fmt::format("{} of {} [{:.3f}, {:.3f}]", row.worst_held, trials,
                                                        row.worst_share_interval.low, row.worst_share_interval.high),
                              times_claimed(row.median_ratio) + ", " + times_claimed(row.largest_ratio)});
    }
    return without_idle_columns(std::move(table));
}

}  // namespace ff::reports

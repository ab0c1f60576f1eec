#include "reports/tables/tables.hpp"
#include "reports/text/idle_columns.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/reduction_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace ff::reports {
namespace {

/// The method's name, after that of its scene where there are several.
std::string method_label(const studies::StudyPlan& plan, const studies::Cell& cell) {
    const std::string& method = plan.spec.methods[cell.method].name;
    return plan.scenes.size() == 1 ? method : fmt::format("{}: {}", plan.scenes[cell.scene].name, method);
}

}  // namespace

Table error_law_table(const studies::StudyResults& results) {
    Table table{"error-law",
                "How the error of the deterministic methods falls",
                "Closure error (mean row sum − 1) with m patches along an edge, fitted by c/m; the exponent fitted "
                "freely beside it.",
                {{"method", false, ""},
                 {"c", true, ""},
                 {"largest residual of c/m", true, ""},
                 {"free exponent", true, "", true},
                 {"m", false, "", true},
                 {"closure error", false, "", true}},
                {},
                {}};
    for (const studies::ErrorLaw& law : results.error_laws) {
        std::vector<std::string> errors;
        for (const double error : law.closure_errors) errors.push_back(fmt::format("{:+.6f}", error));
        table.rows.push_back({{law.method + (law.published ? ", as printed" : "")},
                              {fmt::format("{:+.4f}", law.first_order.coefficient)},
                              {brief(100 * law.first_order.largest_residual, 2) + " %"},
                              {law.free ? fmt::format("{:.4f}", law.free->exponent) : "–"},
                              {fmt::format("{}", fmt::join(law.m, ", "))},
                              {fmt::format("{}", fmt::join(errors, ", "))}});
    }
    for (const studies::ErrorLaw& printed : results.error_laws) {
        if (!printed.published) continue;
        for (const studies::ErrorLaw& ours : results.error_laws) {
            if (ours.published || ours.method != printed.method) continue;
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
    Table table{"reductions",
                "Variance against random points",
                fmt::format("How many times less variance than the method with sampler random and the same scene, "
                            "estimator, completion and size, on the pairs of a class together; intervals of level "
                            "{:g} allow for the spread of both over trials. As many points for both: the factor is "
                            "also that of the efficiency per point.",
                            plan.spec.level),
                {{"method", false, ""},
                 {"pairs", false, ""},
                 {"times less variance", true, ""},
                 {"size", false, "", true},
                 {"allocation", false, "", true}},
                {},
                {}};
    for (const studies::VarianceReduction& reduction : results.reductions) {
        const studies::Cell& cell = plan.cells[reduction.cell];
        const studies::Method& method = plan.spec.methods[cell.method];
        const bool shoots = estimator_info(method).observes == Observes::hits;
        table.rows.push_back({{method_label(plan, cell)},
                              {std::string(name(reduction.pair_class))},
                              {factor_text(reduction)},
                              {size_label(plan, cell)},
                              {shoots ? std::string(studies::name(method.allocation)) : "–"}});
    }
    return without_idle_columns(std::move(table));
}

Table coverage_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "coverage",
        "How often intervals cover",
        fmt::format(
            "The trials of each method are cut into groups of R, each of which gives one interval of level {0:g} for "
            "each of some pairs that share no points; the share of intervals that contain the exact value, with its "
            "own Clopper-Pearson interval. Stopping rules begin with R trials and aim at the half-width that 4 R have "
            "on average. Marked: significantly short of {0:g} (Šidák over all rows, {1:g} % together).",
            plan.spec.level, 100 * (1 - plan.spec.level)),
        {{"method", false, ""},
         {"pairs", false, ""},
         {"interval", false, ""},
         {"R", true, ""},
         {"coverage", true, ""},
         {"remark", false, "", true},
         {"mean trials", true, "", true},
         {"intervals", true, "", true},
         {"size", false, "", true}},
        {},
        {}};
    for (const studies::Coverage& row : results.coverage) {
        const studies::Cell& cell = plan.cells[row.cell];
        const bool infinite = results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
        table.rows.push_back({{method_label(plan, cell)},
                              {std::string(name(row.pair_class))},
                              {std::string(rule_in_words(row.interval_method))},
                              {std::to_string(row.replicates)},
                              {fmt::format("{:.4f} [{:.4f}, {:.4f}]", row.share(), row.coverage_interval.low,
                                           row.coverage_interval.high),
                               row.short_of_nominal ? Mark::bad : Mark::none},
                              {infinite ? "infinite variance" : ""},
                              {fmt::format("{:.1f}", row.mean_trials)},
                              {std::to_string(row.intervals)},
                              {size_label(plan, cell)}});
    }
    return without_idle_columns(std::move(table));
}

Table spreads_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{"spreads",
                "The sampled spread against the exact one",
                "With n independent rays from each of P patches Var F = (1/P²) Σ F_p (1 − F_p) / n, from exact "
                "patch-to-face factors; row sums likewise. Two-sided χ² tests of every pair and row sum; p adjusted by "
                "Holm over these and by Šidák over methods and sizes.",
                {{"method and size", false, ""},
                 {"verdict", false, ""},
                 {"sampled / exact standard deviation", true, ""},
                 {"smallest adjusted p", true, "", true},
                 {"quantities", true, "", true}},
                {},
                {}};
    for (const studies::VarianceCheck& check : results.variance_checks) {
        const bool differs = check.adjusted_p < 1 - plan.spec.level;
        table.rows.push_back({{cell_label(plan, plan.cells[check.cell])},
                              {differs ? "differs" : "agrees", differs ? Mark::bad : Mark::good},
                              {fmt::format("{:.3f} to {:.3f}", check.smallest_ratio, check.largest_ratio)},
                              {p_value(check.adjusted_p)},
                              {std::to_string(check.quantities.size())}});
    }
    return table;
}

}  // namespace ff::reports

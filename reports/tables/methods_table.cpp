#include "reports/tables/tables.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/sizes.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::reports {
namespace {

std::string rmse_text(const studies::CellAnalysis& found, PairClass pair_class) {
    const studies::ClassError* error = found.class_error(pair_class);
    if (found.has_infinite_variance(pair_class)) return "infinite";
    if (error == nullptr) return "–";
    if (!error->interval) return brief(error->rmse);
    const double half = error->interval->width() / 2;
    if (half <= error->rmse / 2) return with_half_width(error->rmse, half);
    return with_ends(error->rmse, error->interval->low, error->interval->high);
}

std::string sum_error_text(const studies::CellAnalysis& found) {
    for (const studies::Summary& summary : found.summaries) {
        if (summary.quantity.kind != studies::QuantityKind::sum_relative_error || !summary.mean) continue;
        if (!summary.q025 || summary.q025 == summary.q975) return brief(*summary.mean);
        return with_ends(*summary.mean, *summary.q025, *summary.q975);
    }
    return "–";
}

/// The mean, with ± half its interval where no exact value shows its error.
std::string mean_text(const studies::Summary& s) {
    if (!s.mean) return "–";
    if (s.reference || !s.mean_interval) return to_error(*s.mean, s.bias_se.value_or(0.0));
    return with_half_width(*s.mean, s.mean_interval->width() / 2);
}

}  // namespace

Table methods_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    bool others = false;
    for (const auto& found : results.findings.cells) others |= found.class_error(PairClass::other) != nullptr;
    Table table{
        "methods",
        "Methods and sizes",
        fmt::format(
            "Sizes are patches per face × evaluations of each. RMSE: of one run against the exact form factors, over "
            "trials and the pairs of a class; ± "
            "half the width of its {:g} % interval, or [its ends] where that is over half the RMSE (the rule for "
            "means, over trials). Σ r.e.: sum over faces of "
            "100 |row sum − 1|, mean and range of 95 % of single runs. Bias: all distinct pairs "
            "together (allowing for skewness, Holm over pairs, Šidák over methods and sizes, {:g} % over the whole "
            "study); in brackets the bias that would be detected with power {:g}. A deterministic method has no "
            "other error than its bias.",
            100 * plan.spec.level, 100 * (1 - plan.spec.level), plan.spec.power),
        columns({"method and size"}),
        {},
        plan.warnings};
    std::vector<PairClass> classes{PairClass::parallel, PairClass::adjacent};
    if (others) classes.push_back(PairClass::other);
    // Where space is short, one class is shown: adjacent pairs, or those of any other scene.
    for (const PairClass each : classes)
        table.columns.push_back({fmt::format("RMSE, {} pairs", name(each)), true, "", each != classes.back()});
    table.columns.push_back({"bias (would detect)"});
    const bool margin = plan.spec.equivalence_margin.has_value();
    if (margin) table.columns.push_back({margin_title(plan.spec), false, "", true});
    table.columns.push_back({"Σ r.e. (%)", true, "", true});
    table.columns.push_back({"trials", true, "", true});
    const auto hidden = cells_in_between(results);
    for (const studies::CellAnalysis& found : results.findings.cells) {
        if (hidden.contains(found.cell)) continue;
        const studies::Cell& cell = plan.cells[found.cell];
        std::vector<TableCell> row{cell_label(plan, cell)};
        for (const PairClass each : classes) row.push_back(rmse_text(found, each));
        row.push_back({bias_in_words(found), bias_mark(found)});
        if (margin) row.push_back({equivalence_in_words(found), equivalence_mark(found.equivalence)});
        row.push_back(sum_error_text(found));
        row.push_back(std::to_string(found.trials));
        table.rows.push_back(std::move(row));
    }
    if (!hidden.empty()) {
        table.remarks.push_back(
            fmt::format("{} sizes in the middle of ladders are not listed; summary.csv has them.", hidden.size()));
    }
    return without_idle_columns(std::move(table));
}

Table pairs_table(const studies::StudyResults& results, std::size_t cell_index) {
    const studies::StudyPlan& plan = results.findings.plan;
    const studies::CellAnalysis& found = results.findings.cells[cell_index];
    const studies::Cell& cell = plan.cells[found.cell];
    const Scene& scene = plan.scenes[cell.scene];
    Table table{
        fmt::format("pairs-{}", cell_index), fmt::format("{}, pair by pair", cell_label(plan, cell)),
        cell.deterministic ? "Deterministic: one run says all, and the bias is the error."
                           : fmt::format("Intervals: of the mean of {} trials, level {:g}, each row on its own.",
                                         found.trials, plan.spec.level),
        columns({"", ">~exact", ">mean", ">bias", ">~z", ">~interval of the bias", ">~detectable", ">~std of a run"})};
    const bool reciprocal = plan.spec.methods[cell.method].completion == studies::Completion::reciprocal;
    for (const studies::Summary& s : found.summaries) {
        const bool follows =
            s.quantity.kind == studies::QuantityKind::form_factor && reciprocal && s.quantity.to < s.quantity.from;
        if (follows || s.quantity.kind == studies::QuantityKind::sum_relative_error) continue;
        const auto number = [](const std::optional<double>& value, std::string_view format) {
            return value ? fmt::format(fmt::runtime(format), *value) : std::string("–");
        };
        std::vector<TableCell> row{quantity_label(scene, s.quantity)};
        row.push_back(number(s.reference, "{:.9f}"));
        row.push_back(mean_text(s));
        row.push_back(number(s.bias, "{:+.2e}"));
        row.push_back(s.bias && s.bias_se ? fmt::format("{:+.2f}", *s.bias / *s.bias_se) : "–");
        row.push_back(s.bias_interval ? fmt::format("[{:+.2e}, {:+.2e}]", s.bias_interval->low, s.bias_interval->high)
                                      : "–");
        row.push_back(number(s.minimum_detectable_bias, "{:.2e}"));
        row.push_back(number(s.std, "{:.3e}"));
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace ff::reports

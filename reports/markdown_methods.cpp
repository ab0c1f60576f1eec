#include "reports/labels.hpp"
#include "reports/markdown_sections.hpp"
#include "reports/numbers.hpp"
#include "reports/verdicts.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string rmse_text(const studies::CellFindings& found, PairClass pair_class) {
    const auto value = found.class_rmse(pair_class);
    if (value) return brief(*value);
    return found.has_infinite_variance(pair_class) ? "infinite" : "–";
}

std::string sum_error_text(const studies::CellFindings& found) {
    for (const studies::Summary& summary : found.summaries) {
        if (summary.quantity.kind != studies::QuantityKind::sum_relative_error || !summary.mean) continue;
        if (!summary.q025 || found.trials < 2) return brief(*summary.mean);
        return fmt::format("{} [{}, {}]", brief(*summary.mean), brief(*summary.q025), brief(*summary.q975));
    }
    return "–";
}

}  // namespace

std::string methods_section(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## Methods and sizes\n\n"
        "RMSE against the exact form factors, over trials and the pairs of a class. Σ r.e. is the sum over faces of "
        "100 |row sum − 1|: its mean, and in brackets the range of 95 % of single runs. Bias is tested on all distinct "
        "pairs together (Student t, Holm over pairs, Šidák over methods and sizes, family-wise {:g} % over the whole "
        "study); "
        "in parentheses the bias that the test detects with power {:g}. Equivalence is shown where the {:g} % interval "
        "of "
        "every pair lies inside the margin.\n\n"
        "| method | size (patches a face) | trials | RMSE parallel | RMSE adjacent | Σ r.e. (%) | bias | equivalence "
        "|\n"
        "|---|---|--:|--:|--:|--:|---|---|\n",
        100 * (1 - plan.spec.level), plan.spec.power, 100 * (2 * plan.spec.level - 1));
    for (const studies::CellFindings& found : results.findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + ": ";
        out += fmt::format("| {}{} | {} | {} | {} | {} | {} | {} | {} |\n", scene, plan.spec.methods[cell.method].name,
                           size_label(plan, cell), found.trials, rmse_text(found, PairClass::parallel),
                           rmse_text(found, PairClass::adjacent), sum_error_text(found), bias_in_words(found),
                           equivalence_in_words(found));
    }
    for (const std::string& warning : plan.warnings) out += fmt::format("\n> {}\n", warning);
    return out + "\n";
}

}  // namespace ff::reports

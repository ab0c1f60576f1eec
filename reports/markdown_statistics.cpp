#include "reports/labels.hpp"
#include "reports/markdown_sections.hpp"
#include "reports/numbers.hpp"
#include "reports/verdicts.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string bias_row(const Scene& scene, const studies::Summary& s) {
    const std::string exact = s.reference ? fmt::format("{:.9f}", *s.reference) : "–";
    const std::string mean = s.mean ? to_error(*s.mean, s.bias_se.value_or(0.0)) : "–";
    const std::string bias = s.bias ? fmt::format("{:+.2e}", *s.bias) : "–";
    const std::string z = s.bias && s.bias_se ? fmt::format("{:+.2f}", *s.bias / *s.bias_se) : "–";
    const std::string interval =
        s.bias_interval ? fmt::format("[{:+.2e}, {:+.2e}]", s.bias_interval->low, s.bias_interval->high) : "–";
    const std::string detectable = s.minimum_detectable_bias ? fmt::format("{:.2e}", *s.minimum_detectable_bias) : "–";
    std::string std = s.std ? fmt::format("{:.3e}", *s.std) : "–";
    if (s.std_interval) {
        const bool chi_squared = s.std_interval->method.starts_with("chi");
        std += fmt::format(" [{:.3e}, {:.3e}]{}", s.std_interval->low, s.std_interval->high, chi_squared ? "" : " b");
    }
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", quantity_label(scene, s.quantity), exact,
                       mean, bias, z, interval, detectable, std, s.normality_p ? p_value(*s.normality_p) : "–");
}

bool constant(const studies::Summary& s) {
    return s.std && *s.std == 0;
}

}  // namespace

std::string bias_section(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## Bias pair by pair\n\n"
        "z is bias / standard error (Student t with trials − 1 degrees of freedom); the interval is Student's t, level "
        "{:g}, "
        "each pair by itself; *detectable* is the bias that the study-wide test at {:g} % finds with power {:g}. "
        "Intervals of "
        "the standard deviation are χ², or bootstrap where the kurtosis forbids it (summary.csv says which trials they "
        "rest "
        "on). Normality: Anderson-Darling, hit counts jittered by half a hit. All distinct pairs and the row sums.\n\n",
        plan.spec.level, 100 * (1 - plan.spec.level), plan.spec.power, plan.spec.level);
    for (const studies::CellFindings& found : results.findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        const Scene& scene = plan.scenes[cell.scene];
        const bool reciprocal = plan.spec.methods[cell.method].completion == studies::Completion::reciprocal;
        out += fmt::format("<details><summary>{} ({} trial{}): {}</summary>\n\n", cell_label(plan, cell), found.trials,
                           found.trials == 1 ? "" : "s", bias_in_words(found));
        out +=
            "| | exact | mean | bias | z | interval | detectable | standard deviation of a run | normality p "
            "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
        for (const studies::Summary& s : found.summaries) {
            const bool follows =
                s.quantity.kind == studies::QuantityKind::form_factor && reciprocal && s.quantity.to < s.quantity.from;
            if (!follows && s.quantity.kind != studies::QuantityKind::sum_relative_error) out += bias_row(scene, s);
        }
        out += "\n";
        for (const studies::Summary& s : found.summaries) {
            if (s.variance != studies::VarianceStatus::infinite ||
                s.quantity.kind != studies::QuantityKind::form_factor)
                continue;
            out +=
                "Pairs that touch have infinite variance with this estimator: no interval or test holds for them, so "
                "none is shown.\n\n";
            break;
        }
        for (const studies::Summary& s : found.summaries) {
            if (s.quantity.kind == studies::QuantityKind::row_sum && constant(s)) {
                out += fmt::format("{} is {:g} in every trial: closure fixes it.\n\n",
                                   quantity_label(scene, s.quantity), *s.mean);
            }
        }
        out += "</details>\n\n";
    }
    return out;
}

std::string variance_section(const studies::StudyResults& results) {
    if (results.variance_checks.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out =
        "## The sampled spread against the exact one\n\n"
        "With n independent rays from each of P patches Var F = (1/P²) Σ F_p (1 − F_p) / n, from exact patch-to-face "
        "factors; "
        "row sums likewise. Two-sided χ² tests of every pair and row sum, Holm.\n\n"
        "| method and size | quantities | sampled / exact standard deviation | smallest adjusted p | "
        "|\n|---|--:|--:|--:|---|\n";
    for (const studies::VarianceCheck& check : results.variance_checks) {
        out +=
            fmt::format("| {} | {} | {:.3f} to {:.3f} | {} | {} |\n", cell_label(plan, plan.cells[check.cell]),
                        check.quantities.size(), check.smallest_ratio, check.largest_ratio, p_value(check.adjusted_p),
                        check.adjusted_p < 1 - plan.spec.level ? "**differs**" : "agrees");
    }
    return out + "\n";
}

std::string reproduction_section(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format("## To do it again\n\nSeed {}. The study, in full:\n\n```toml\n{}```\n\n",
                                  plan.spec.seed.value, studies::to_toml(plan.spec));
    out += "Everything above depends on these lines alone: not on threads, machine or interruptions.\n\n";
    if (results.context.empty()) return out;
    out += "<!-- circumstances: not part of the result -->\n\n| circumstances | |\n|---|---|\n";
    for (const auto& [key, value] : results.context) out += fmt::format("| {} | {} |\n", key, value);
    return out + "\n<!-- end of circumstances -->\n";
}

}  // namespace ff::reports

#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/tables/tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/study_text.hpp"
#include "reports/words/findings/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ff::reports {
namespace {

using studies::CellAnalysis;
using studies::QuantityKind;
using studies::StudyPlan;
using studies::Summary;

std::optional<double> t_statistic(const Summary& s) {
    return s.bias && s.bias_se ? std::optional(*s.bias / *s.bias_se) : std::nullopt;
}

std::string t_text(const Summary& s) {
    const auto t = t_statistic(s);
    return t ? fmt::format("{:+.2f}", *t) : "–";
}

/// The pair with the largest |t|, or with the largest error where nothing is tested.
const Summary* worst_pair(const CellAnalysis& found) {
    if (found.bias && found.bias->largest_t > 0) return &found.summary(found.bias->largest_pair);
    const Summary* worst = nullptr;
    for (const Summary& s : found.summaries) {
        if (s.quantity.kind != QuantityKind::form_factor) continue;
        if (worst == nullptr || std::abs(s.bias.value_or(0.0)) > std::abs(worst->bias.value_or(0.0))) worst = &s;
    }
    return worst;
}

std::string worst_row(const StudyPlan& plan, const studies::Cell& cell, const Summary& s) {
    const std::string exact = s.reference ? fmt::format("{:.9f}", *s.reference) : "–";
    const std::string mean = s.mean ? to_error(*s.mean, s.bias_se.value_or(0.0)) : "–";
    const std::string bias = s.bias ? fmt::format("{:+.2e}", *s.bias) : "–";
    const std::string interval =
        s.bias_interval ? fmt::format("[{:+.2e}, {:+.2e}]", s.bias_interval->low, s.bias_interval->high) : "–";
    const std::string detectable = s.minimum_detectable_bias ? fmt::format("{:.2e}", *s.minimum_detectable_bias) : "–";
    std::string std = s.std && s.variance != studies::VarianceStatus::infinite ? fmt::format("{:.3e}", *s.std) : "–";
    if (s.std_interval) {
        const bool chi_squared = s.std_interval->method.starts_with("chi");
        std += fmt::format(" [{:.3e}, {:.3e}]{}", s.std_interval->low, s.std_interval->high, chi_squared ? "" : " b");
    }
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                       markdown_cell(cell_label(plan, cell)),
                       markdown_cell(quantity_label(plan.scenes[cell.scene], s.quantity)), exact, mean, bias, t_text(s),
                       interval, detectable, std, s.normality_p ? p_value(*s.normality_p) : "–",
                       s.vov ? brief(*s.vov, 2) : "–", s.tail_index ? fmt::format("{:.1f}", *s.tail_index) : "–");
}

std::string worst_table(const studies::Analysis& findings) {
    std::string out =
        "| method and size | pair | exact | mean | bias | t | interval | detectable | standard deviation of a run | "
        "normality p | VOV | tail index |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const CellAnalysis& found : findings.cells) {
        if (const Summary* worst = worst_pair(found))
            out += worst_row(findings.plan, findings.plan.cells[found.cell], *worst);
    }
    return out;
}

}  // namespace

std::string bias_section(const studies::StudyResults& results) {
    const StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## Bias pair by pair\n\n"
        "Of every method and size the pair with the largest |t|, t = bias / standard error; of a deterministic method "
        "the pair with the largest error. The interval allows for skewness, level {:g}, for the pair by itself; "
        "*detectable* is the bias that the study-wide test at {:g} % finds with "
        "power {:g}. Intervals of the standard deviation are χ², or bootstrap (b) where the kurtosis forbids it. "
        "Normality: Anderson-Darling, hit counts jittered by half a hit. VOV is below 0.1 in a healthy tally; a tail "
        "index below 2 means infinite variance. All pairs, with all their statistics: "
        "summary.csv.\n\n",
        plan.spec.level, 100 * (1 - plan.spec.level), plan.spec.power);
    return out + folded_if_long(worst_table(results.findings) + "\n", results.findings.cells.size());
}

std::string reproduction_section(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const StudyText study = study_text(plan.spec);
    std::string out =
        fmt::format("## Reproduce\n\nSeed {}. {}\n\n{}\n", plan.spec.seed.value,
                    study.whole ? "The study, in full:" : whole_study_is_kept, markdown_code("toml", study.text));
    out += "Everything above depends on these lines alone: not on threads, machine or interruptions.";
    if (const std::string program = program_label(results.context); !program.empty())
        out += fmt::format(" Made by {}.", program);
    return out + " When, where and how fast: context.json.\n";
}

}  // namespace ff::reports

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

std::string interval_text(const std::optional<stats::Interval>& interval) {
    return interval ? fmt::format("[{:.3f}, {:.3f}]", interval->low, interval->high) : "–";
}

std::string with_interval(double value, const std::optional<stats::Interval>& interval) {
    if (!interval) return brief(value);
    return with_ends(value, interval->low, interval->high);
}

std::string size_rows(const studies::ClassSlopes& found) {
    std::string out;
    for (const studies::ClassError& size : found.sizes) {
        const bool infinite = size.status == studies::VarianceStatus::infinite;
        out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", name(found.pair_class), size.evaluations,
                           infinite ? "infinite" : brief(size.rmse), brief(size.median_abs_error),
                           with_interval(size.bias, size.bias_interval),
                           size.efficiency ? with_interval(*size.efficiency, size.efficiency_interval) : "–");
    }
    return out;
}

std::string pair_rows(const Scene& scene, const studies::LadderSlopes& ladder) {
    std::string out;
    for (std::size_t i = 0; i + 1 < ladder.pairs.size(); i += 2) {
        const studies::Slope& rmse = ladder.pairs[i];
        const studies::Slope& median = ladder.pairs[i + 1];
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", markdown_cell(quantity_label(scene, *rmse.pair)),
                           name(rmse.pair_class), rmse.slope ? fmt::format("{:.3f}", *rmse.slope) : "–",
                           interval_text(rmse.interval), rmse.lack_of_fit_p ? p_value(*rmse.lack_of_fit_p) : "–",
                           median.slope ? fmt::format("{:.3f}", *median.slope) : "–", interval_text(median.interval));
    }
    return out;
}

std::string ladder_details(const studies::StudyPlan& plan, const studies::LadderSlopes& ladder) {
    std::string out = fmt::format("<details><summary>{}{}: sizes {}, pair by pair</summary>\n\n",
                                  escape_html(scene_prefix(plan, ladder.ladder.scene)),
                                  escape_html(ladder.ladder.label), sizes_text(plan, ladder.ladder));
    out +=
        "| pairs | N | RMSE | median of the absolute error | mean bias | efficiency 1 / (RMSE² N) "
        "|\n|---|--:|--:|--:|--:|--:|\n";
    for (const studies::ClassSlopes& found : ladder.classes) out += size_rows(found);
    out +=
        "\n| pair | class | RMSE slope | interval | lack of fit p | median slope | interval "
        "|\n|---|---|--:|--:|--:|--:|--:|\n";
    out += pair_rows(plan.scenes[ladder.ladder.scene], ladder);
    return out + "\n</details>\n\n";
}

using studies::CellAnalysis;
using studies::Completion;
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

/// Whether other rows say all of it: sums of relative errors, and pairs that follow by reciprocity.
bool follows(const Summary& s, Completion completion) {
    switch (s.quantity.kind) {
        case QuantityKind::form_factor:
            return completion == Completion::reciprocal && s.quantity.to < s.quantity.from;
        case QuantityKind::row_sum:
            return false;
        case QuantityKind::sum_relative_error:
            break;
    }
    return true;
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

/// t of every pair and row sum, a row for each sampled cell of one scene and completion; empty where there is none.
std::string t_table(const studies::Analysis& findings, std::size_t scene, Completion completion) {
    const StudyPlan& plan = findings.plan;
    std::string header = "| method and size |";
    std::string rule = "|---|";
    std::string rows;
    for (const CellAnalysis& found : findings.cells) {
        const studies::Cell& cell = plan.cells[found.cell];
        if (cell.scene != scene || !found.bias || plan.spec.methods[cell.method].completion != completion) continue;
        const bool first = rows.empty();
        rows += fmt::format("| {} |", markdown_cell(cell_label(plan, cell)));
        for (const Summary& s : found.summaries) {
            if (follows(s, completion)) continue;
            if (first) header += fmt::format(" {} |", markdown_cell(quantity_label(plan.scenes[scene], s.quantity)));
            if (first) rule += "--:|";
            rows += fmt::format(" {} |", t_text(s));
        }
        rows += "\n";
    }
    return rows.empty() ? std::string() : header + "\n" + rule + "\n" + rows + "\n";
}

}  // namespace

std::string slopes_section(const studies::StudyResults& results) {
    std::string out = markdown_section(convergence_table(results));
    for (const studies::LadderSlopes& ladder : results.slopes) out += ladder_details(results.findings.plan, ladder);
    return out;
}

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
    out += worst_table(results.findings) + "\n";
    std::string tables;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (const Completion completion : {Completion::direct, Completion::reciprocal})
            tables += t_table(results.findings, scene, completion);
    }
    if (tables.empty()) return out;
    return out +
           fmt::format(
               "<details><summary>t of every pair and row sum</summary>\n\n{}No t where the value never varies "
               "(closure fixes the sum), where there are too few hits or the trials are too skewed, and under infinite "
               "variance (pairs that touch, with the area kernel).\n\n</details>\n\n",
               tables);
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

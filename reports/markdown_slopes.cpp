#include "reports/labels.hpp"
#include "reports/markdown_sections.hpp"
#include "reports/numbers.hpp"
#include "reports/slope_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string interval_text(const std::optional<stats::Interval>& interval) {
    return interval ? fmt::format("[{:.3f}, {:.3f}]", interval->low, interval->high) : "–";
}

std::string number(const std::optional<double>& value, int digits = 3) {
    return value ? brief(*value, digits) : "–";
}

std::string with_interval(const std::optional<double>& value, const std::optional<stats::Interval>& interval) {
    if (!value) return "–";
    if (!interval) return brief(*value);
    return fmt::format("{} [{}, {}]", brief(*value), brief(interval->low), brief(interval->high));
}

std::string theory(const studies::Slope& slope) {
    if (!slope.expected) return "none known";
    return fmt::format("{} [{}]: {}", expected_text(slope), slope.expected->source, slope.expected->because);
}

std::string class_row(const studies::LadderSlopes& ladder, const studies::ClassSlopes& found) {
    const studies::Slope& judged = found.judged();
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", ladder.ladder.label,
                       name(found.pair_class), found.rmse.slope ? fmt::format("{:.3f}", *found.rmse.slope) : "–",
                       interval_text(found.rmse.interval), interval_text(found.rmse.from_fit),
                       found.rmse.lack_of_fit_p ? p_value(*found.rmse.lack_of_fit_p) : "–",
                       found.median.slope ? fmt::format("{:.3f}", *found.median.slope) : "–",
                       interval_text(found.median.interval), theory(judged), finding_in_words(found));
}

std::string size_rows(const studies::ClassSlopes& found) {
    std::string out;
    for (const studies::ClassErrors& size : found.sizes) {
        out +=
            fmt::format("| {} | {} | {} | {} | {} | {} |\n", name(found.pair_class), size.evaluations,
                        number(size.rmse), number(size.median_abs_error), with_interval(size.bias, size.bias_interval),
                        with_interval(size.efficiency, size.efficiency_interval));
    }
    return out;
}

std::string pair_rows(const Scene& scene, const studies::LadderSlopes& ladder) {
    std::string out;
    for (std::size_t i = 0; i + 1 < ladder.pairs.size(); i += 2) {
        const studies::Slope& rmse = ladder.pairs[i];
        const studies::Slope& median = ladder.pairs[i + 1];
        out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", quantity_label(scene, *rmse.pair),
                           name(rmse.pair_class), rmse.slope ? fmt::format("{:.3f}", *rmse.slope) : "–",
                           interval_text(rmse.interval), rmse.lack_of_fit_p ? p_value(*rmse.lack_of_fit_p) : "–",
                           median.slope ? fmt::format("{:.3f}", *median.slope) : "–", interval_text(median.interval));
    }
    return out;
}

std::string ladder_details(const studies::StudyPlan& plan, const studies::LadderSlopes& ladder) {
    std::string out = fmt::format("<details><summary>{}: sizes {}, pair by pair</summary>\n\n", ladder.ladder.label,
                                  sizes_text(plan, ladder.ladder));
    out +=
        "| pairs | N | RMSE | median of the absolute error | mean bias | efficiency 1 / (variance N) "
        "|\n|---|--:|--:|--:|--:|--:|\n";
    for (const studies::ClassSlopes& found : ladder.classes) out += size_rows(found);
    out +=
        "\n| pair | class | RMSE slope | interval | lack of fit p | median slope | interval "
        "|\n|---|---|--:|--:|--:|--:|--:|\n";
    out += pair_rows(plan.scenes[ladder.ladder.scene], ladder);
    return out + "\n</details>\n\n";
}

}  // namespace

std::string slopes_section(const studies::StudyResults& results) {
    if (results.slopes.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## Convergence\n\n"
        "Slope of ln(error) on ln N, N evaluations for a face (for a pair of faces with area_kernel): weighted least "
        "squares with Var(ln MSE) = ψ₁(T/2), scaled by how trials vary. Two intervals of level {0:g}: by bootstrap "
        "over "
        "whole trials (whose pairs may depend on each other), and from the weights of the fit. *Lack of fit*: χ² of "
        "the "
        "straight line. *Theory*: the rate expected, with its source; \"≤\" where it only bounds the error; a range "
        "where powers of ln N slow it down at these sizes. Verdicts: Holm over all rows with a theory, {1:g} % "
        "together.\n\n",
        plan.spec.level, 100 * (1 - plan.spec.level));
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        std::string rows;
        std::string details;
        for (const studies::LadderSlopes& ladder : results.slopes) {
            if (ladder.ladder.scene != scene) continue;
            for (const studies::ClassSlopes& found : ladder.classes) rows += class_row(ladder, found);
            details += ladder_details(plan, ladder);
        }
        if (rows.empty()) continue;
        if (plan.scenes.size() > 1) out += fmt::format("### {}\n\n", plan.scenes[scene].name);
        out +=
            "| method | pairs | RMSE slope | bootstrap | from the fit | lack of fit p | median slope | bootstrap | "
            "theory | |\n"
            "|---|---|--:|--:|--:|--:|--:|--:|---|---|\n" +
            rows + "\n" + details;
    }
    return out;
}

}  // namespace ff::reports

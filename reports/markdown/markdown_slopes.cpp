#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_table.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/tables/tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/slope_words.hpp"

#include <fmt/format.h>

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
    const std::string scene = plan.scenes.size() == 1 ? "" : plan.scenes[ladder.ladder.scene].name + ": ";
    std::string out = fmt::format("<details><summary>{}{}: sizes {}, pair by pair</summary>\n\n", escape_html(scene),
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

}  // namespace

std::string slopes_section(const studies::StudyResults& results) {
    std::string out = markdown_section(convergence_table(results));
    for (const studies::LadderSlopes& ladder : results.slopes) out += ladder_details(results.findings.plan, ladder);
    return out;
}

}  // namespace ff::reports

#include "reports/terminal/terminal.hpp"

#include "reports/tables/tables.hpp"
#include "reports/terminal/terminal_sections.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"
#include "reports/words/audit_summary.hpp"
#include "reports/words/cells_in_between.hpp"
#include "reports/words/findings/claim_words.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/findings/reduction_words.hpp"
#include "reports/words/findings/tail_words.hpp"
#include "reports/words/findings/until_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/published_summary.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

/// Nothing for a table without rows.
std::string titled(const Table& table, const TextStyle& style) {
    if (table.rows.empty()) return {};
    return fmt::format("\n{}\n{}", table.title, text_table(table, style));
}

/// The same with the sentences below it; these alone where there are no rows.
std::string explained(const Table& table, const TextStyle& style) {
    std::string out = titled(table, style);
    if (out.empty() && !table.remarks.empty()) out = fmt::format("\n{}\n", table.title);
    for (const std::string& remark : table.remarks) out += remark + "\n";
    return out;
}

/// Two significant digits where nothing is known about the error of the third.
std::string rmse(const studies::StudyPlan& plan, const studies::CellAnalysis& found, PairClass pair_class) {
    const auto value = found.class_rmse(pair_class);
    if (!value) return found.has_infinite_variance(pair_class) ? "infinite" : "-";
    const bool known = plan.cells[found.cell].deterministic || found.class_error(pair_class)->interval;
    return fmt::format("{:.{}e}", *value, known ? 2 : 1);
}

/// With the scene, where there are several.
std::string scene_and_method(const studies::StudyPlan& plan, const studies::CellAnalysis& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + " ";
    return scene + plan.spec.methods[cell.method].name;
}

/// A row for each method and size that is not hidden.
Table summary_table(const studies::StudyResults& results, const std::set<std::size_t>& hidden) {
    const studies::StudyPlan& plan = results.findings.plan;
    const bool equivalence = plan.spec.equivalence_margin.has_value();
    Table table{"summary",
                "",
                "",
                {{"method", false, ""},
                 {"size (patches per face)", false, ""},
                 {"trials", true, ""},
                 {"parallel", true, "RMSE of a run"},
                 {"adjacent", true, "RMSE of a run"},
                 {"bias, all pairs together", false, ""}},
                {},
                {}};
    if (equivalence) table.columns.push_back({"equivalence", false, ""});
    for (const studies::CellAnalysis& found : results.findings.cells) {
        if (hidden.contains(found.cell)) continue;
        std::vector<TableCell> row{{scene_and_method(plan, found), Mark::none},
                                   {size_label(plan, plan.cells[found.cell]), Mark::none},
                                   {std::to_string(found.trials), Mark::none},
                                   {rmse(plan, found, PairClass::parallel), Mark::none},
                                   {rmse(plan, found, PairClass::adjacent), Mark::none},
                                   {bias_in_words(found), bias_mark(found)}};
        if (found.lost_rays > 0)
            row.back() = {fmt::format("{} rays LOST; {}", found.lost_rays, row.back().text), Mark::bad};
        if (equivalence) row.push_back({equivalence_in_words(found), equivalence_mark(found.equivalence)});
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

std::string terminal_summary(const studies::StudyResults& results, const TextStyle& style) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::string title = plan.spec.title == plan.spec.name ? "" : fmt::format(": {}", plan.spec.title);
    const auto hidden = cells_in_between(results);
    std::string out = fmt::format("{}{}\nseed {}{}\n\n{}", plan.spec.name, title, plan.spec.seed.value,
                                  results.findings.complete ? "" : "  (PARTIAL: stopped early)",
                                  text_table(summary_table(results, hidden), style));
    for (const studies::CellAnalysis& found : results.findings.cells) {
        if (found.repeated_trials > 0) out += fmt::format("WARNING {}\n", studies::repeats_in_words(plan, found));
    }
    if (!hidden.empty())
        out += fmt::format("({} sizes{}: summary.csv)\n", hidden.size(),
                           results.occlusion.empty() ? " in between" : " of scenes below");
    out += titled(occlusion_table(results), style);
    if (results.occlusion.empty()) {
        out += titled(configurations_table(results), style);
        out += terminal_slopes(results, style);
        out += terminal_plots(results, style);
    }
    for (const auto& lines : {occlusion_in_brief(results), heavy_tails_in_brief(results), reductions_in_brief(results),
                              coverage_in_brief(results), one_run_errors_in_brief(results), radiosity_in_brief(results),
                              until_in_brief(results)}) {
        if (!lines.empty()) out += fmt::format("\n{}\n", fmt::join(lines, "\n"));
    }
    if (results.occlusion.empty()) {
        out += explained(decisions_table(results, true), style);
        out += explained(contests_table(results, true), style);
    }
    out += explained(claimed_errors_table(results, Claims::stated), style);
    if (results.published) {
        out += fmt::format("\nPublished: {}\n", results.published->tables.source);
        for (const std::string& line : published_in_brief(*results.published, 1 - plan.spec.level))
            out += fmt::format("{}\n", line);
        if (!results.published->tables.figures.empty())
            out += audit_summary(results.published->tables, results.published->audit);
    }
    return out;
}

}  // namespace ff::reports

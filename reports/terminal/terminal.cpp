#include "reports/terminal/terminal.hpp"

#include "reports/tables/tables.hpp"
#include "reports/terminal/terminal_sections.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"
#include "reports/words/audit_summary.hpp"
#include "reports/words/cells_in_between.hpp"
#include "reports/words/coverage_words.hpp"
#include "reports/words/occlusion_words.hpp"
#include "reports/words/published_summary.hpp"
#include "reports/words/radiosity_words.hpp"
#include "reports/words/reduction_words.hpp"
#include "reports/words/tail_words.hpp"
#include "reports/words/until_words.hpp"
#include "reports/words/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

/// Nothing for a table without rows.
std::string titled(const Table& table, Colour colour) {
    return table.rows.empty() ? "" : fmt::format("\n{}\n{}", table.title, text_table(table, colour));
}

/// Two significant digits where nothing is known about the error of the third.
std::string rmse(const studies::StudyPlan& plan, const studies::CellFindings& found, PairClass pair_class) {
    const auto value = found.class_rmse(pair_class);
    if (!value) return found.has_infinite_variance(pair_class) ? "infinite" : "-";
    const bool known = plan.cells[found.cell].deterministic || found.class_error(pair_class)->interval;
    return fmt::format("{:.{}e}", *value, known ? 2 : 1);
}

/// With the scene, where there are several.
std::string method_of(const studies::StudyPlan& plan, const studies::CellFindings& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + " ";
    return scene + plan.spec.methods[cell.method].name;
}

}  // namespace

std::string terminal_summary(const studies::StudyResults& results, Colour colour) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::string title = plan.spec.title == plan.spec.name ? "" : fmt::format(": {}", plan.spec.title);
    std::string out = fmt::format("{}{}\nseed {}{}\n\n", plan.spec.name, title, plan.spec.seed.value,
                                  results.findings.complete ? "" : "  (PARTIAL: stopped early)");
    const auto hidden = cells_in_between(results);
    std::vector<const studies::CellFindings*> shown;
    std::size_t names = 15;
    std::size_t sizes = 20;
    for (const studies::CellFindings& found : results.findings.cells) {
        if (hidden.contains(found.cell)) continue;
        shown.push_back(&found);
        names = std::max(names, visible_length(method_of(plan, found)));
        sizes = std::max(sizes, visible_length(size_label(plan, plan.cells[found.cell])));
    }
    const auto add_row = [&](std::string_view method, std::string_view size, std::string_view trials,
                             std::string_view parallel, std::string_view adjacent, const std::string& verdict) {
        out += fmt::format("{:<{}} {:<{}} {:>6}  {:>8}  {:>8}  {}\n", method, names, size, sizes, trials, parallel,
                           adjacent, verdict);
    };
    add_row("method", "size", "trials", "RMSE", "RMSE", "bias");
    add_row("", "patches per face × …", "", "parallel", "adjacent", "(all pairs together)");
    for (const studies::CellFindings* found : shown) {
        const std::string margin = equivalence_in_words(*found);
        add_row(method_of(plan, *found), size_label(plan, plan.cells[found->cell]), std::to_string(found->trials),
                rmse(plan, *found, PairClass::parallel), rmse(plan, *found, PairClass::adjacent),
                painted(bias_in_words(*found), bias_mark(*found), colour) + (margin.empty() ? "" : "; ") +
                    painted(margin, equivalence_mark(found->equivalence), colour));
        if (found->lost_rays > 0)
            out += fmt::format("{:<{}} {}\n", "", names,
                               painted(fmt::format("{} rays LOST", found->lost_rays), Mark::bad, colour));
    }
    if (!hidden.empty())
        out += fmt::format("({} sizes{}: summary.csv)\n", hidden.size(),
                           results.occlusion.empty() ? " in between" : " of scenes below");
    out += titled(occlusion_table(results), colour);
    if (results.occlusion.empty()) {
        out += titled(configurations_table(results), colour);
        out += terminal_slopes(results, colour);
        out += terminal_plots(results);
    }
    for (const auto& lines : {occlusion_in_brief(results), heavy_tails_in_brief(results), reductions_in_brief(results),
                              coverage_in_brief(results), radiosity_in_brief(results), until_in_brief(results)}) {
        if (!lines.empty()) out += fmt::format("\n{}\n", fmt::join(lines, "\n"));
    }
    if (results.published) {
        out += fmt::format("\nPublished: {}\n", results.published->tables.source);
        for (const std::string& line : published_in_brief(*results.published, 1 - plan.spec.level))
            out += fmt::format("{}\n", line);
        out += audit_summary(results.published->tables, results.published->audit);
    }
    return out;
}

}  // namespace ff::reports

#include "reports/terminal.hpp"

#include "reports/audit_markdown.hpp"
#include "reports/cells_in_between.hpp"
#include "reports/coverage_words.hpp"
#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/occlusion_words.hpp"
#include "reports/published_summary.hpp"
#include "reports/radiosity_words.hpp"
#include "reports/reduction_words.hpp"
#include "reports/tail_words.hpp"
#include "reports/terminal_sections.hpp"
#include "reports/text_table.hpp"
#include "reports/until_words.hpp"
#include "reports/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

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

Mark mark_of(const studies::CellFindings& found) {
    if (!found.bias) return Mark::none;
    if (found.bias_finding == studies::BiasFinding::untestable) return Mark::open;
    return found.bias_finding == studies::BiasFinding::biased ? Mark::bad : Mark::good;
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
    add_row("", "patches a face × …", "", "parallel", "adjacent", "(all pairs together)");
    for (const studies::CellFindings* found : shown) {
        const std::string margin = equivalence_in_words(*found);
        add_row(method_of(plan, *found), size_label(plan, plan.cells[found->cell]), std::to_string(found->trials),
                rmse(plan, *found, PairClass::parallel), rmse(plan, *found, PairClass::adjacent),
                painted(fmt::format("{}{}{}", bias_in_words(*found), margin.empty() ? "" : "; ", margin),
                        mark_of(*found), colour));
        if (found->lost_rays > 0)
            out += fmt::format("{:<{}} {}\n", "", names,
                               painted(fmt::format("{} rays LOST", found->lost_rays), Mark::bad, colour));
    }
    if (!hidden.empty())
        out += fmt::format("({} sizes{}: summary.csv)\n", hidden.size(),
                           results.occlusion.empty() ? " in between" : " of scenes below");
    out += terminal_occlusion(results, colour);
    if (results.occlusion.empty()) {
        out += terminal_configurations(results, colour);
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

#include "reports/terminal.hpp"

#include "reports/audit_markdown.hpp"
#include "reports/coverage_words.hpp"
#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/published_summary.hpp"
#include "reports/reduction_words.hpp"
#include "reports/tail_words.hpp"
#include "reports/terminal_sections.hpp"
#include "reports/until_words.hpp"
#include "reports/verdicts.hpp"
#include "studies/resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace ff::reports {
namespace {

std::string rmse(const studies::CellFindings& found, PairClass pair_class) {
    const auto value = found.class_rmse(pair_class);
    if (value) return fmt::format("{:.2e}", *value);
    return found.has_infinite_variance(pair_class) ? "infinite" : "-";
}

/// Cells in the middle of long ladders: there the slopes say more. What must be seen is never among them.
std::set<std::size_t> hidden_cells(const studies::StudyResults& results) {
    std::set<std::size_t> hidden;
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const auto& cells = ladder.ladder.cells;
        if (cells.size() < 5) continue;
        hidden.insert(std::next(cells.begin()), std::prev(cells.end()));
    }
    for (const studies::CellFindings& found : results.findings.cells) {
        const bool remarkable =
            found.lost_rays > 0 || (found.bias && found.bias_finding == studies::BiasFinding::biased);
        if (remarkable || found.equivalence == studies::EquivalenceFinding::refuted) hidden.erase(found.cell);
    }
    return hidden;
}

std::string seconds_in_words(double seconds) {
    return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

}  // namespace

std::string terminal_summary(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const std::string title = plan.spec.title == plan.spec.name ? "" : fmt::format(": {}", plan.spec.title);
    std::string out = fmt::format("{}{}\nseed {}{}\n\n", plan.spec.name, title, plan.spec.seed.value,
                                  results.findings.complete ? "" : "  (PARTIAL: stopped early)");
    out += fmt::format("{:<15} {:<20} {:>6}  {:>8}  {:>8}  {}\n", "method", "size", "trials", "RMSE", "RMSE", "bias");
    out += fmt::format("{:<15} {:<20} {:>6}  {:>8}  {:>8}  {}\n", "", "patches a face × …", "", "parallel", "adjacent",
                       "(all pairs together)");
    const auto hidden = hidden_cells(results);
    for (const studies::CellFindings& found : results.findings.cells) {
        if (hidden.contains(found.cell)) continue;
        const studies::Cell& cell = plan.cells[found.cell];
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + " ";
        const std::string margin = equivalence_in_words(found);
        out += fmt::format("{:<15} {:<20} {:>6}  {:>8}  {:>8}  {}{}{}\n", scene + plan.spec.methods[cell.method].name,
                           size_label(plan, cell), found.trials, rmse(found, PairClass::parallel),
                           rmse(found, PairClass::adjacent), bias_in_words(found), margin.empty() ? "" : "; ", margin);
        if (found.lost_rays > 0) out += fmt::format("{:<15} {} rays LOST\n", "", found.lost_rays);
    }
    if (!hidden.empty()) out += fmt::format("({} sizes in between: report.md)\n", hidden.size());
    out += terminal_slopes(results);
    for (const auto& lines : {heavy_tails_in_brief(results), reductions_in_brief(results), coverage_in_brief(results),
                              until_in_brief(results)}) {
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

std::string terminal_plan(const studies::StudyPlan& plan, unsigned threads) {
    std::string out = fmt::format("{}: {} work units\n\n{:<15} {:<20} {:>8} {:>14} {:>12}\n", plan.spec.name,
                                  plan.units.size(), "method", "size", "trials", "samples/trial", "core time");
    double total = 0;
    for (const studies::Cell& cell : plan.cells) {
        const double seconds = static_cast<double>(cell.trials) * studies::expected_seconds_per_trial(plan, cell);
        total += seconds;
        out += fmt::format("{:<15} {:<20} {:>8} {:>14} {:>12}\n", plan.spec.methods[cell.method].name,
                           size_label(plan, cell), cell.trials, studies::evaluations_per_trial(plan, cell),
                           seconds_in_words(seconds));
    }
    const double expected = total / threads + studies::expected_seconds_of_results(plan);
    out += fmt::format("\nabout {} on {} thread{}\n", seconds_in_words(expected), threads, threads == 1 ? "" : "s");
    return out;
}

}  // namespace ff::reports

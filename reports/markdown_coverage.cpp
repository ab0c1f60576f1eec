#include "reports/coverage_words.hpp"
#include "reports/labels.hpp"
#include "reports/markdown_sections.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string coverage_section(const studies::StudyResults& results) {
    if (results.coverage.empty()) return {};
    const studies::StudyPlan& plan = results.findings.plan;
    std::string out = fmt::format(
        "## How often intervals cover\n\n"
        "The trials of each method are cut into groups of R, each of which gives one interval of level {0:g} for each "
        "of "
        "some pairs that share no points; the share of intervals that contain the exact value, with its own "
        "Clopper-Pearson interval. Stopping rules begin with R trials and aim at the half-width that 4 R have on "
        "average. **Bold**: significantly short of {0:g} (Šidák over all rows, {1:g} % together).\n\n"
        "| method | size | pairs | interval | R | mean trials | intervals | coverage | "
        "|\n|---|---|---|---|--:|--:|--:|--:|---|\n",
        plan.spec.level, 100 * (1 - plan.spec.level));
    for (const studies::Coverage& row : results.coverage) {
        const studies::Cell& cell = plan.cells[row.cell];
        const std::string scene = plan.scenes.size() == 1 ? std::string() : plan.scenes[cell.scene].name + ": ";
        const std::string share = fmt::format("{:.4f} [{:.4f}, {:.4f}]", row.share(), row.actual.low, row.actual.high);
        const bool infinite = results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
        out += fmt::format("| {}{} | {} | {} | {} | {} | {:.1f} | {} | {} | {} |\n", scene,
                           plan.spec.methods[cell.method].name, size_label(plan, cell), name(row.pair_class),
                           rule_in_words(row.rule), row.replicates, row.mean_trials, row.intervals,
                           row.short_of_nominal ? fmt::format("**{}**", share) : share,
                           infinite ? "infinite variance" : "");
    }
    return out + "\n";
}

}  // namespace ff::reports

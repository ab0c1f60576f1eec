#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/table.hpp"
#include "reports/terminal_sections.hpp"
#include "reports/text_table.hpp"
#include "reports/verdicts.hpp"

#include "studies/configuration_estimates.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

Mark mark_of(const studies::CellFindings& found) {
    if (!found.bias || found.bias_finding == studies::BiasFinding::untestable) return Mark::open;
    return found.bias_finding == studies::BiasFinding::biased ? Mark::bad : Mark::good;
}

std::string verdict(const studies::CellFindings& found) {
    if (!found.bias) return "deterministic";
    return found.bias_finding == studies::BiasFinding::no_bias_found ? "agrees" : bias_in_words(found);
}

std::string interval_of(const studies::ConfigurationEstimate& estimate) {
    if (!estimate.interval) return "–";
    return fmt::format("[{}, {}]", to_error(estimate.interval->low, estimate.error),
                       to_error(estimate.interval->high, estimate.error));
}

}  // namespace

Table configurations_table(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Table table{
        "configurations",
        "Against the exact values of the catalogue",
        fmt::format("Mean over trials, its {:g} % interval by itself, and how many of its standard errors it is off "
                    "(of a deterministic method: the error). The verdict is that of the bias test, {:g} % over "
                    "the whole study. A surface that sees itself is estimated by what it sends to another.",
                    100 * plan.spec.level, 100 * (1 - plan.spec.level)),
        {{"configuration", false, ""},
         {"method and size", false, ""},
         {"estimate", true, ""},
         {"interval", false, ""},
         {"exact", true, ""},
         {"off by", true, ""},
         {"verdict", false, ""}},
        {},
        {}};
    if (!results.occlusion.empty()) return table;  // which has a table of its own
    for (const studies::ConfigurationEstimate& row : studies::configuration_estimates(results.findings)) {
        const studies::Cell& cell = plan.cells[row.found->cell];
        table.rows.push_back(
            {{std::string(row.configuration->name)},
             {fmt::format("{}, {}", plan.spec.methods[cell.method].name, size_label(plan, cell))},
             {to_error(row.mean, row.error)},
             {interval_of(row)},
             {fmt::format("{:.12f}", row.exact)},
             {row.standard_errors ? fmt::format("{:+.2f} SE", *row.standard_errors) : fmt::format("{:+.1e}", row.bias)},
             {verdict(*row.found), mark_of(*row.found)}});
    }
    return table;
}

std::string terminal_configurations(const studies::StudyResults& results, Colour colour) {
    const Table table = configurations_table(results);
    return table.rows.empty() ? "" : fmt::format("\n{}\n{}", table.title, text_table(table, colour));
}

}  // namespace ff::reports

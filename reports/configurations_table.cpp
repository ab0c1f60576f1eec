#include "reports/labels.hpp"
#include "reports/numbers.hpp"
#include "reports/table.hpp"
#include "reports/terminal_sections.hpp"
#include "reports/text_table.hpp"
#include "reports/verdicts.hpp"

#include "core/configurations/catalogue.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::reports {
namespace {

/// The statistics of a configuration's pair of faces; where it is one face to itself, those of what leaves it.
const studies::Summary& summary_of(const studies::CellFindings& found, const Configuration& configuration) {
    const int to = configuration.from == configuration.to ? 1 - configuration.to : configuration.to;
    return found.summary({studies::QuantityKind::form_factor, configuration.from + 1, to + 1});
}

Mark mark_of(const studies::CellFindings& found) {
    if (!found.bias || found.bias_finding == studies::BiasFinding::untestable) return Mark::open;
    return found.bias_finding == studies::BiasFinding::biased ? Mark::bad : Mark::good;
}

std::string verdict(const studies::CellFindings& found) {
    if (!found.bias) return "deterministic";
    return found.bias_finding == studies::BiasFinding::no_bias_found ? "agrees" : bias_in_words(found);
}

void add_row(const studies::StudyPlan& plan, const studies::CellFindings& found, const Configuration& configuration,
             Table& table) {
    const studies::Summary& summary = summary_of(found, configuration);
    if (!summary.mean || !summary.reference) return;
    const studies::Cell& cell = plan.cells[found.cell];
    const int others = other_faces(plan.scenes[cell.scene], configuration);
    const bool itself = others > 0;
    const auto own = [&](double value) { return itself ? 1 - others * value : value; };
    const double error = (itself ? others : 1) * summary.bias_se.value_or(std::abs(summary.bias.value_or(0)));
    std::string interval = "–";
    if (summary.bias_interval) {
        const double low = own(*summary.reference + summary.bias_interval->low);
        const double high = own(*summary.reference + summary.bias_interval->high);
        interval = fmt::format("[{}, {}]", to_error(itself ? high : low, error), to_error(itself ? low : high, error));
    }
    const bool has_error = summary.bias_se && *summary.bias_se > 0;
    table.rows.push_back({{std::string(configuration.name)},
                          {fmt::format("{}, {}", plan.spec.methods[cell.method].name, size_label(plan, cell))},
                          {to_error(own(*summary.mean), error)},
                          {interval},
                          {fmt::format("{:.12f}", own(*summary.reference))},
                          {has_error ? fmt::format("{:+.2f} SE", (itself ? -1 : 1) * *summary.bias / *summary.bias_se)
                                     : fmt::format("{:+.1e}", (itself ? -1 : 1) * summary.bias.value_or(0))},
                          {verdict(found), mark_of(found)}});
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
    for (const Configuration& configuration : configurations()) {
        for (const studies::CellFindings& found : results.findings.cells) {
            if (is_configuration(plan.scenes[plan.cells[found.cell].scene], configuration) && found.trials > 0)
                add_row(plan, found, configuration, table);
        }
    }
    return table;
}

std::string terminal_configurations(const studies::StudyResults& results, Colour colour) {
    const Table table = configurations_table(results);
    return table.rows.empty() ? "" : fmt::format("\n{}\n{}", table.title, text_table(table, colour));
}

}  // namespace ff::reports

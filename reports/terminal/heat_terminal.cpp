#include "reports/terminal/heat_terminal.hpp"

#include "reports/tables/heat_tables.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::reports {

std::string heat_text(const HeatReport& report, const TextStyle& style) {
    constexpr std::size_t most_flows_shown = 40;
    std::string text;
    const auto add = [&](Table table) {
        const auto remarks = std::exchange(table.remarks, {});
        text += text_table(table, style);
        for (const std::string& remark : remarks) text += remark + "\n";
        text += "\n";
    };
    const auto& first = report.cases.front();
    auto groups = groups_table(report);
    const bool shows_faces = !report.has_cases() && (!groups || first.flows.faces.size() <= most_flows_shown);
    if (groups) {
        if (!shows_faces) groups->remarks.push_back("Single faces are in heat.csv (--out).");
        add(std::move(*groups));
    }
    if (shows_faces) add(flows_table(report, first, most_flows_shown));
    for (const auto& solved : report.cases) text += heat_balance(report, solved) + "\n";
    if (report.has_cases() || first.flows.reaches_outside) text += "\n";
    const std::string effort = heat_effort(report);
    return text + heat_verdict(report) + "\n" + (effort.empty() ? "" : effort + "\n");
}

}  // namespace ff::reports

#include "reports/tables/heat_tables.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {

using studies::heat::FaceFlow;
using studies::heat::Flows;
using studies::heat::GroupFlow;
using studies::heat::SolvedCase;

namespace {

/// All faces, or those with the largest powers where there are many.
std::vector<std::size_t> shown_faces(const Flows& flows, std::size_t most) {
    std::vector<std::size_t> faces(flows.faces.size());
    std::iota(faces.begin(), faces.end(), std::size_t{0});
    if (faces.size() <= most) return faces;
    std::stable_sort(faces.begin(), faces.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(flows.faces[a].power.middle()) > std::abs(flows.faces[b].power.middle());
    });
    faces.resize(most);
    return faces;
}

bool tell_more_than_faces(const SolvedCase& solved) {
    return solved.materials.has_named_groups || std::ranges::any_of(solved.flows.groups, [](const GroupFlow& group) {
               return group.faces > 1 && (group.power.low != 0 || group.power.high != 0);
           });
}

/// A column of a quantity, whose unit stands above its name.
TableColumn quantity(const HeatReport& report, std::string_view name, std::string_view unit) {
    return {std::string(name), true, std::string(report.is_light() ? "" : unit)};
}

}  // namespace

std::optional<Table> groups_table(const HeatReport& report) {
    if (!report.has_cases() && !tell_more_than_faces(report.cases.front())) return std::nullopt;
    Table table{"groups", "Groups of faces", "", columns({"group", ">faces"})};
    if (report.has_cases()) table.columns.insert(table.columns.begin(), {"case"});
    table.columns.push_back(quantity(report, "power", "W"));
    table.columns.push_back({"share", true, "%"});
    table.columns.push_back(quantity(report, "net", "W/m²"));
    table.columns.push_back(quantity(report, "area", "m²"));
    for (const SolvedCase& solved : report.cases) {
        const bool at_rest = solved.flows.are_at_rest();
        for (const GroupFlow& group : solved.flows.groups) {
            const auto& share = group.share;
            auto& row = table.rows.emplace_back(
                std::vector<TableCell>{group.name, std::to_string(group.faces), with_error(group.power, at_rest),
                                       share ? with_error({100 * share->low, 100 * share->high}) : "-",
                                       with_error(group.net(), at_rest), brief(group.area, 6)});
            if (report.has_cases()) row.insert(row.begin(), solved.materials.name);
        }
    }
    return table;
}

Table flows_table(const HeatReport& report, const SolvedCase& solved, std::size_t most) {
    const Scene& scene = report.scene;
    const bool at_rest = solved.flows.are_at_rest();
    const bool light = report.is_light();
    Table table{"flows", "Flows", "", {{"face"}}};
    table.columns.push_back(quantity(report, "power", "W"));
    if (!light) table.columns.push_back(quantity(report, "temperature", "K"));
    table.columns.push_back(quantity(report, "net", "W/m²"));
    table.columns.push_back(quantity(report, light ? "exitance" : "radiosity", "W/m²"));
    table.columns.push_back(quantity(report, light ? "incident" : "irradiation", "W/m²"));
    table.columns.push_back(quantity(report, "area", "m²"));
    for (const std::size_t i : shown_faces(solved.flows, most)) {
        const FaceFlow& flow = solved.flows.faces[i];
        std::vector<TableCell> row{scene.faces[i], with_error(flow.power, at_rest)};
        if (!light) row.emplace_back(with_error(flow.temperature));
        row.emplace_back(with_error(flow.net, at_rest));
        row.emplace_back(with_error(flow.radiosity));
        row.emplace_back(with_error(flow.irradiation));
        row.emplace_back(brief(flow.area, 6));
        table.rows.push_back(std::move(row));
    }
    if (scene.faces.size() > table.rows.size())
        table.remarks.push_back(fmt::format("{} faces of the largest powers, of {}; all are in heat.csv (--out).",
                                            table.rows.size(), scene.faces.size()));
    return table;
}

}  // namespace ff::reports

#include "reports/terminal/heat_text.hpp"

#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace ff::reports {
namespace {

using studies::Bounds;

std::string with_error(const Bounds& bounds) {
    if (bounds.half_width() <= 1e-9 * std::abs(bounds.middle())) return brief(bounds.middle(), 6);
    return fmt::format("{} ± {}", to_error(bounds.middle(), bounds.half_width()), brief(bounds.half_width(), 2));
}

TableCell cell(std::string text) {
    return {std::move(text), Mark::none};
}

}  // namespace

std::string heat_text(const HeatReport& report, const TextStyle& style) {
    const auto& [scene, request, materials, flows] = report;
    const bool light = materials.are_light();
    Table table{"heat",
                "",
                "",
                {{"face", false, {}},
                 {"area", true, light ? "" : "m²"},
                 {light ? "exitance" : "radiosity", true, light ? "" : "W/m²"},
                 {light ? "incident" : "irradiation", true, light ? "" : "W/m²"},
                 {"net", true, light ? "" : "W/m²"},
                 {"power", true, light ? "" : "W"}},
                {},
                {}};
    if (!light) table.columns.push_back({"temperature", true, "K"});
    for (std::size_t i = 0; i < scene.faces.size(); ++i) {
        const studies::FaceFlow& flow = flows.faces[i];
        table.rows.push_back({cell(scene.faces[i]), cell(brief(flow.area, 6)), cell(with_error(flow.radiosity)),
                              cell(with_error(flow.irradiation)), cell(with_error(flow.net)),
                              cell(with_error(flow.power))});
        if (!light) table.rows.back().push_back(cell(with_error(flow.temperature)));
    }
    std::string out = text_table(table, style);
    if (flows.to_surroundings)
        out += fmt::format("\nTo the surroundings: {}{}\n", with_error(*flows.to_surroundings), light ? "" : " W");
    out +=
        fmt::format("\nEvery power is within {} % of the {}{} that the sources give off, all at once at level {:g}.\n",
                    brief(100 * flows.worst, 2), brief(flows.throughput, 4), light ? "" : " W", request.level);
    return out;
}

}  // namespace ff::reports

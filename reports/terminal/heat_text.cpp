#include "reports/terminal/heat_text.hpp"

#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"
#include "reports/words/scene_reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::heat::Bounds;

/// @param is_rounding  the value is 0 up to rounding
std::string with_error(const Bounds& bounds, bool is_rounding = false) {
    if (bounds.half_width() <= 1e-9 * std::abs(bounds.middle())) return brief(bounds.middle(), 6);
    constexpr double unseen = 0.01;
    if (is_rounding || std::abs(bounds.middle()) < unseen * bounds.half_width())
        return fmt::format("0 ± {}", brief(bounds.half_width(), 2));
    return with_half_width(bounds.middle(), bounds.half_width());
}

constexpr std::size_t most_flows_shown = 40;

/// All faces, or those with the largest powers where there are many.
std::vector<std::size_t> shown_faces(const studies::heat::Flows& flows, std::size_t most) {
    std::vector<std::size_t> faces(flows.faces.size());
    std::iota(faces.begin(), faces.end(), std::size_t{0});
    if (faces.size() <= most) return faces;
    std::stable_sort(faces.begin(), faces.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(flows.faces[a].power.middle()) > std::abs(flows.faces[b].power.middle());
    });
    faces.resize(most);
    return faces;
}

std::string_view unit_of_power(const HeatReport& report) {
    return report.materials.are_light() ? "" : " W";
}

}  // namespace

Table heat_table(const HeatReport& report, std::size_t most) {
    const Scene& scene = report.scene;
    const studies::heat::Flows& flows = report.flows;
    const bool light = report.materials.are_light();
    const bool at_rest = flows.are_at_rest();
    Table table{"flows",
                "",
                "",
                {{"face"},
                 {"area", true, light ? "" : "m²"},
                 {light ? "exitance" : "radiosity", true, light ? "" : "W/m²"},
                 {light ? "incident" : "irradiation", true, light ? "" : "W/m²"},
                 {"net", true, light ? "" : "W/m²"},
                 {"power", true, light ? "" : "W"}}};
    if (!light) table.columns.push_back({"temperature", true, "K"});
    for (const std::size_t i : shown_faces(flows, most)) {
        const studies::heat::FaceFlow& flow = flows.faces[i];
        table.rows.push_back({scene.faces[i], brief(flow.area, 6), with_error(flow.radiosity),
                              with_error(flow.irradiation), with_error(flow.net, at_rest),
                              with_error(flow.power, at_rest)});
        if (!light) table.rows.back().push_back(with_error(flow.temperature));
    }
    if (scene.faces.size() > table.rows.size())
        table.remarks.push_back(fmt::format("{} faces of the largest powers, of {}; all are in heat.csv (--out).",
                                            table.rows.size(), scene.faces.size()));
    return table;
}

std::string heat_verdict(const HeatReport& report) {
    const studies::heat::Flows& flows = report.flows;
    if (flows.are_at_rest())
        return fmt::format("Nothing is exchanged: every power is 0 within {}{} (the faces emit {}{}).",
                           brief(flows.worst, 2), unit_of_power(report), brief(flows.emitted, 4),
                           unit_of_power(report));
    return fmt::format("Every power is within {} % of the {}{} that the sources give off, all at once at level {:g}.",
                       brief(100 * flows.worst / flows.throughput, 2), brief(flows.throughput, 4),
                       unit_of_power(report), report.request.level);
}

std::string heat_effort(const HeatReport& report) {
    if (report.sampled == nullptr || report.sampled->samples == 0) return {};
    const studies::heat::SampledFlows& sampled = *report.sampled;
    if (!sampled.even_samples) return fmt::format("{} samples.", thousands_apart(sampled.samples));
    return fmt::format("{} samples; with one tolerance for all form factors about {} (estimated).",
                       thousands_apart(sampled.samples), brief(*sampled.even_samples, 2));
}

std::string heat_balance(const HeatReport& report) {
    const Bounds& balance = report.flows.balance;
    if (report.flows.reaches_outside)
        return fmt::format("To the surroundings: {}{}", with_error(balance), unit_of_power(report));
    return fmt::format("Balance: the powers add up to {}{}.", with_error(balance, report.flows.are_at_rest()),
                       unit_of_power(report));
}

std::string heat_text(const HeatReport& report, const TextStyle& style) {
    Table table = heat_table(report, most_flows_shown);
    const auto remarks = std::exchange(table.remarks, {});
    std::string out = text_table(table, style);
    for (const std::string& remark : remarks) out += remark + "\n";
    const std::string effort = heat_effort(report);
    return fmt::format("{}\n{}\n{}{}\n{}", out, heat_balance(report), report.flows.reaches_outside ? "\n" : "",
                       heat_verdict(report), effort.empty() ? "" : effort + "\n");
}

}  // namespace ff::reports

#include "reports/html/scene_html.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/mirrors.hpp"
#include "reports/html/html_view.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/tables/heat_tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/terminal/scene_terminal.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using Eigen::Vector3d;
constexpr std::size_t most_polygons = 30'000;
constexpr std::size_t most_matrix_rows = 300;
constexpr int facet_rings = 8;  // rings of facets on a round surface
constexpr int facets_per_ring = 24;

void add_polygon(Json& polygons, int face, const std::vector<Vector3d>& corners) {
    constexpr int digits = 6;
    Json polygon = Json::array({face});
    for (const Vector3d& corner : corners) {
        for (const double coordinate : corner) polygon.push_back(drawn(coordinate, digits));
    }
    polygons.push_back(std::move(polygon));
}

void add_facets(Json& polygons, int face, const Surface& surface) {
    const SurfaceMap map(surface);
    for (int i = 0; i < facet_rings; ++i) {
        for (int k = 0; k < facets_per_ring; ++k) {
            const auto at = [&](int s, int t) {
                return map.at(s / double{facet_rings}, t % facets_per_ring / double{facets_per_ring}).position;
            };
            std::vector<Vector3d> corners{at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)};
            const Vector3d normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
            const Vector3d outwards = map.at((i + 0.5) / facet_rings, (k + 0.5) / facets_per_ring).normal;
            if (normal.dot(outwards) < 0) std::reverse(corners.begin(), corners.end());
            add_polygon(polygons, face, corners);
        }
    }
}

Json polygons_json(const Scene& scene) {
    Json polygons = Json::array();
    const std::size_t step = (scene.surfaces.size() + most_polygons - 1) / most_polygons;
    for (std::size_t i = 0; i < scene.surfaces.size(); i += step) {
        const Surface& surface = scene.surfaces[i];
        const int face = is_of_face(surface) ? surface.face : -1;
        if (!is_polygon(surface.shape))
            add_facets(polygons, face, surface);
        else
            add_polygon(polygons, face, outline(surface));
    }
    return polygons;
}

/// A quantity with, for every face, its value and half the width of its interval.
template <class Value>
Json quantity_json(std::string_view name, std::string_view unit, std::size_t faces, Value value_of) {
    constexpr int digits = 9;
    Json values = Json::array();
    Json errors = Json::array();
    for (std::size_t face = 0; face < faces; ++face) {
        const studies::heat::Bounds bounds = value_of(face);
        values.push_back(drawn(bounds.middle(), digits));
        errors.push_back(drawn(bounds.half_width(), 2));
    }
    return {{"name", name}, {"unit", unit}, {"values", values}, {"errors", errors}};
}

/// The page shows single faces of the first few cases.
std::span<const studies::heat::SolvedCase> drawn_cases(const HeatReport& heat) {
    constexpr std::size_t most_cases = 8;
    return std::span(heat.cases).first(std::min(most_cases, heat.cases.size()));
}

Json quantities_json(const FormFactorReport& report, const HeatReport* heat) {
    const std::size_t faces = report.scene.faces.size();
    Json quantities = Json::array();
    if (heat != nullptr) {
        const bool light = heat->is_light();
        for (const studies::heat::SolvedCase& solved : drawn_cases(*heat)) {
            const std::string& name_of_case = solved.materials.name;
            const auto add = [&](std::string_view name, std::string_view unit,
                                 studies::heat::Bounds studies::heat::FaceFlow::*member) {
                quantities.push_back(quantity_json(
                    name_of_case.empty() ? std::string(name) : fmt::format("{}: {}", name_of_case, name),
                    light ? "" : unit, faces, [&](std::size_t face) { return solved.flows.faces[face].*member; }));
            };
            add("net flux", "W/m²", &studies::heat::FaceFlow::net);
            add(light ? "exitance" : "radiosity", "W/m²", &studies::heat::FaceFlow::radiosity);
            add(light ? "incident light" : "irradiation", "W/m²", &studies::heat::FaceFlow::irradiation);
            add("power", "W", &studies::heat::FaceFlow::power);
            if (!light) add("temperature", "K", &studies::heat::FaceFlow::temperature);
        }
    }
    quantities.push_back(quantity_json("sum of the row", "", faces, [&](std::size_t face) {
        return studies::heat::Bounds{report.matrix.rows[face].low, report.matrix.rows[face].high};
    }));
    return quantities;
}

Json matrix_json(const FormFactorReport& report) {
    const std::size_t faces = report.scene.faces.size();
    const std::size_t step = (faces + most_matrix_rows - 1) / most_matrix_rows;
    std::vector<std::map<std::size_t, std::pair<double, double>>> rows((faces + step - 1) / step);
    const auto add = [&](std::size_t from, std::size_t to, const studies::form_factors::FaceExchange& exchange) {
        const double area = report.matrix.areas[from];
        auto& entry = rows[from / step][to / step];
        entry = std::max(entry, {exchange.value / area, half_width(exchange) / area});
    };
    for (const studies::form_factors::FaceExchange& exchange : report.matrix.exchanges) {
        if (exchange.high <= 0) continue;
        add(exchange.from, exchange.to, exchange);
        if (exchange.from != exchange.to) add(exchange.to, exchange.from, exchange);
    }
    constexpr int digits = 5;
    Json list = Json::array();
    for (const auto& row : rows) {
        Json entries = Json::array();
        for (const auto& [column, entry] : row) {
            entries.push_back(column);
            entries.push_back(drawn(entry.first, digits));
            entries.push_back(drawn(entry.second, 2));
        }
        list.push_back(std::move(entries));
    }
    return {{"step", step}, {"rows", std::move(list)}};
}

/// The data that scene_report.js draws, as JSON: `faces` (names), `polygons` ([face, x, y, z, ..], counter-clockwise
/// from the radiating side; face -1 marks obstacles; round surfaces as facets), `quantities` of faces (`name`, `unit`,
/// `values`, `errors`: halves of intervals), and `matrix`: [column, factor, error, ..] for each row, and the `step` of
/// faces that a row and a column stand for, by the largest factor of any of them.
/// @param heat  flows computed from the factors; null: none
std::string scene_data(const FormFactorReport& report, const HeatReport* heat) {
    return json_in_html({{"faces", report.scene.faces},
                         {"polygons", polygons_json(report.scene)},
                         {"quantities", quantities_json(report, heat)},
                         {"matrix", matrix_json(report)}});
}

constexpr std::size_t most_listed_faces = 1000;

/// Areas and sums of rows.
Table faces_table(const FormFactorReport& report) {
    Table table{"faces", "Faces", "", columns({"face", ">area", ">sum of the row", ">its interval"})};
    const bool drops = report.request.drop > 0;
    if (drops) table.columns.push_back({"dropped of it", true});
    for (std::size_t face = 0; face < std::min(most_listed_faces, report.scene.faces.size()); ++face) {
        const studies::form_factors::RowSum& sum = report.matrix.rows[face];
        const double width = std::max(sum.high - sum.value, sum.value - sum.low);
        table.rows.push_back({report.scene.faces[face], brief(report.matrix.areas[face], 6), to_error(sum.value, width),
                              fmt::format("{} to {}", to_error(sum.low, width), to_error(sum.high, width))});
        const double half = std::max(sum.dropped.high - sum.dropped.value, sum.dropped.value - sum.dropped.low);
        if (drops) table.rows.back().push_back(with_half_width(sum.dropped.value, half));
    }
    if (report.scene.faces.size() > most_listed_faces)
        table.remarks.push_back(
            fmt::format("The first {} faces, of {}.", most_listed_faces, report.scene.faces.size()));
    return table;
}

/// Groups of all cases, then the faces of some.
std::vector<Table> flows_tables(const HeatReport& heat) {
    std::vector<Table> tables;
    if (auto groups = groups_table(heat)) tables.push_back(std::move(*groups));
    const auto cases = drawn_cases(heat);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Table& table = tables.emplace_back(flows_table(heat, cases[i], most_listed_faces / cases.size()));
        if (!heat.has_cases()) continue;
        table.id += fmt::format("-{}", i + 1);
        table.title += ": " + cases[i].materials.name;
        table.remarks.push_back(heat_balance(heat, cases[i]));
    }
    for (Table& table : tables) table.note = "± is half of an interval; all hold at once.";
    if (cases.size() < heat.cases.size())
        tables.back().remarks.push_back(
            fmt::format("Faces of the first {} cases, of {}; all are in heat.csv.", cases.size(), heat.cases.size()));
    return tables;
}

Json listing(const FormFactorReport& report, const HeatReport* heat) {
    Json views = Json::array();
    for (const Table& table : heat == nullptr ? std::vector{faces_table(report)} : flows_tables(*heat))
        views.push_back(table_view(table));
    return views;
}

}  // namespace

std::string scene_html(const FormFactorReport& report, const std::vector<std::string>& warnings, const HeatReport* heat,
                       const std::string& program, const Templates& templates) {
    const std::string style = templates.text("report.css") + templates.text("scene_report.css");
    const std::string& script = templates.text("scene_report.js");
    const std::array<std::string_view, 1> styles{style};
    const std::array<std::string_view, 1> scripts{script};
    const auto& [scene, request, matrix] = report;
    const std::string verdict = heat == nullptr ? form_factors_verdict(report) : heat_verdict(*heat);
    const std::string answer = heat == nullptr ? std::string() : heat_answer(*heat);
    std::vector<std::string> certainty;
    if (!answer.empty()) certainty.push_back(verdict);
    if (heat != nullptr && !heat->has_cases()) certainty.push_back(heat_balance(*heat, heat->cases.front()));
    const std::string effort = heat == nullptr ? std::string() : heat_effort(*heat);
    const std::string tolerance = heat != nullptr && heat->sampled != nullptr
                                      ? in_words(heat->sampled->tolerance) + " of powers"
                                      : brief(request.tolerance);
    const Json view = {
        {"title", fmt::format("{} of {}", heat == nullptr ? "Form factors" : "Heat", scene.name)},
        {"policy", security_policy(styles, scripts)},
        {"style", style},
        {"script", script},
        {"warnings", texts_view(warnings)},
        {"verdict", answer.empty() ? verdict : answer + "."},
        {"certainty", texts_view(certainty)},
        {"asked",
         fmt::format("{}, {}; tolerance {}, level {} {}, seed {}.{}{}", counted(scene.faces.size(), "face"),
                     counted(scene.surfaces.size(), "surface"), tolerance, brief(request.level, 10),
                     request.level_of == studies::form_factors::LevelOf::entry ? "of each entry" : "of all at once",
                     request.seed.value, effort.empty() ? "" : " ", effort)},
        {"listing", listing(report, heat)},
        {"program", program},
        {"data", scene_data(report, heat)}};
    return fill_template(templates, "scene_report", view, escape_html);
}

}  // namespace ff::reports

#include "reports/html/scene_data.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

namespace ff::reports {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_polygons = 30'000;
constexpr std::size_t most_matrix_rows = 300;
constexpr int facet_rings = 8;  // on a round surface
constexpr int facets_per_ring = 24;

/// Fewer digits: a page is to be sent on.
double short_number(double value, int digits) {
    // Not std::stod: it throws where a number is smaller than doubles of full precision are.
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

void add_polygon(Json& polygons, int face, const std::vector<Vector3d>& corners) {
    constexpr int digits = 6;
    Json polygon = Json::array({face});
    for (const Vector3d& corner : corners) {
        for (const double coordinate : corner) polygon.push_back(short_number(coordinate, digits));
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
        values.push_back(short_number(bounds.middle(), digits));
        errors.push_back(short_number(bounds.half_width(), 2));
    }
    return {{"name", name}, {"unit", unit}, {"values", values}, {"errors", errors}};
}

Json quantities_json(const FormFactorReport& report, const HeatReport* heat) {
    const std::size_t faces = report.scene.faces.size();
    Json quantities = Json::array();
    if (heat != nullptr) {
        const bool light = heat->materials.are_light();
        const auto add = [&](std::string_view name, std::string_view unit,
                             studies::heat::Bounds studies::heat::FaceFlow::*member) {
            quantities.push_back(quantity_json(name, light ? "" : unit, faces,
                                               [&](std::size_t face) { return heat->flows.faces[face].*member; }));
        };
        add("net flux", "W/m²", &studies::heat::FaceFlow::net);
        add(light ? "exitance" : "radiosity", "W/m²", &studies::heat::FaceFlow::radiosity);
        add(light ? "incident light" : "irradiation", "W/m²", &studies::heat::FaceFlow::irradiation);
        add("power", "W", &studies::heat::FaceFlow::power);
        if (!light) add("temperature", "K", &studies::heat::FaceFlow::temperature);
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
            entries.push_back(short_number(entry.first, digits));
            entries.push_back(short_number(entry.second, 2));
        }
        list.push_back(std::move(entries));
    }
    return {{"step", step}, {"rows", std::move(list)}};
}

}  // namespace

std::string scene_data(const FormFactorReport& report, const HeatReport* heat) {
    const Json data = {{"faces", report.scene.faces},
                       {"polygons", polygons_json(report.scene)},
                       {"quantities", quantities_json(report, heat)},
                       {"matrix", matrix_json(report)}};
    // Names may hold what would end the element that this stands in.
    std::string text;
    for (const char c : data.dump()) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace ff::reports

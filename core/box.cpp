#include "core/box.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/families.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/nearest_name.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr double cube_edge = 6;

/// Beyond these, areas squared would leave the range of a double.
constexpr double shortest_edge = 1e-70;
constexpr double longest_edge = 1e70;

void require_edge(std::string_view edge, double length) {
    if (!std::isfinite(length) || length <= 0) {
        throw UserError(
            fmt::format("box edge {} = {} (an edge needs a finite, positive length). Try {} = 1.", edge, length, edge));
    }
    if (length < shortest_edge || length > longest_edge) {
        throw UserError(
            fmt::format("box edge {} = {} (only {} to {} can be computed with). Choose another unit of "
                        "length: form factors do not depend on it.",
                        edge, length, shortest_edge, longest_edge));
    }
}

Surface wall(int face, const Vector3d& corner, const Vector3d& edge_u, const Vector3d& edge_v, const Vector3d& normal) {
    return {Parallelogram{corner, edge_u, edge_v}, normal, face};
}

/// Takes "AxBxC" apart; empty unless it is three numbers.
std::optional<std::array<double, 3>> parse_edges(std::string_view text) {
    std::array<double, 3> edges{};
    const char* next = text.data();
    const char* const end = next + text.size();
    for (double& edge : edges) {
        if (&edge != edges.data()) {
            if (next == end || *next != 'x') return std::nullopt;
            ++next;
        }
        const auto [after, error] = std::from_chars(next, end, edge);
        if (error != std::errc{}) return std::nullopt;
        next = after;
    }
    if (next != end) return std::nullopt;
    return edges;
}

/// "Did you mean" for a scene name that is not known, with the edges that the user gave.
std::string suggestion(std::string_view name) {
    std::vector<std::string_view> known = configuration_scene_names();
    known.insert(known.end(), {"cube", "box"});
    const std::size_t colon = name.find(':');
    const std::string nearest = nearest_name(name.substr(0, colon), known);
    if (!nearest.empty() && nearest != "box") return fmt::format("Did you mean {}?", nearest);
    if (nearest == "box" && colon != std::string_view::npos)
        return fmt::format("Did you mean box{}?", name.substr(colon));
    return "Try cube or box:2x1x0.5.";
}

}  // namespace

Scene make_box(double a, double b, double c) {
    require_edge("a", a);
    require_edge("b", b);
    require_edge("c", c);
    const Vector3d origin = Vector3d::Zero();
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();

    Scene scene;
    scene.name = fmt::format("box:{}x{}x{}", a, b, c);
    scene.canonical = fmt::format("box a={} b={} c={}", a, b, c);
    scene.faces = {"1", "2", "3", "4", "5", "6"};
    scene.surfaces = {
        wall(0, origin, a * x, b * y, z),  //
        wall(1, b * y, a * x, c * z, -y),  //
        wall(2, origin, a * x, c * z, y),  //
        wall(3, origin, b * y, c * z, x),  //
        wall(4, a * x, b * y, c * z, -x),  //
        wall(5, c * z, a * x, b * y, -z),
    };
    scene.closed = true;
    scene.empty_box = Vector3d(a, b, c);
    return scene;
}

Scene built_in_scene(std::string_view name) {
    constexpr std::string_view box_prefix = "box:";
    Scene scene;
    if (name == "cube") {
        scene = make_box(cube_edge, cube_edge, cube_edge);
    } else if (name.substr(0, box_prefix.size()) == box_prefix) {
        const auto edges = parse_edges(name.substr(box_prefix.size()));
        if (!edges) {
            throw UserError(
                fmt::format("scene {} (a box needs three numbers, box:AxBxC). Try box:2x1x0.5.", excerpt(name)));
        }
        scene = make_box((*edges)[0], (*edges)[1], (*edges)[2]);
    } else {
        auto configuration = family_scene(name);
        if (!configuration) configuration = configuration_scene(name);
        if (!configuration) {
            throw UserError(
                fmt::format("scene {} (unknown; built in are cube, box:AxBxC and those that 'ffstudy list "
                            "scenes' shows). {}",
                            excerpt(name), suggestion(name)));
        }
        scene = std::move(*configuration);
    }
    scene.name = name;
    return scene;
}

}  // namespace ff

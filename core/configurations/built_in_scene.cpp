#include "core/configurations/built_in_scene.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/families.hpp"
#include "core/geometry/box.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff {
namespace {

constexpr double cube_edge = 6;

/// Takes "AxBxC" apart; empty unless it is three numbers.
std::optional<std::array<double, 3>> parse_edges(std::string_view text) {
    std::array<double, 3> edges{};
    const auto parts = split_at('x', text);
    if (parts.size() != edges.size()) return std::nullopt;
    for (std::size_t axis = 0; axis < edges.size(); ++axis) {
        const auto edge = parse_bare_number<double>(parts[axis]);
        if (!edge) return std::nullopt;
        edges.at(axis) = *edge;
    }
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

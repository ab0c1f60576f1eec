#include "core/configurations/built_in_scene.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/closed_forms.hpp"
#include "core/configurations/scenes.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
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

namespace scenes = configuration_scenes;

using Factor = std::optional<long double>;

constexpr long double outer_edge = 6;  // edge of the outer of two nested cubes
/// Depths of the second leg that are allowed. A shorter leg is a mere wrinkle; with a longer one the form factor is so
/// small that its formula loses its digits.
constexpr double least_depth = 1e-3;
constexpr double most_depth = 100;
constexpr double least_inner_edge = 1e-3;
constexpr double most_inner_edge = 5.99;

/// The form factor between faces 0 and 1, which is the same both ways; empty from a face to itself.
Factor of_pair(long double factor, int from, int to) {
    return from == to ? std::nullopt : Factor(factor);
}

/// The form factor from the long wall of 3 x 3 to the end of 1 x 3, and back; empty for other pairs.
Factor l_shaped_room(double depth, int from, int to) {
    if (std::min(from, to) != 0 || std::max(from, to) != 1) return std::nullopt;
    return l_shaped_room_exchange_area(depth) / (from == 0 ? 9 : 3);
}

/// The form factor between two faces of the outer cube; empty for other pairs.
Factor nested_cubes(double inner, int from, int to) {
    if (from == to || std::max(from, to) > 5) return std::nullopt;
    constexpr std::array opposite{2, 3, 0, 1, 5, 4};
    return opposite.at(static_cast<std::size_t>(from)) == to ? nested_cubes_opposite_factor(inner, outer_edge)
                                                             : nested_cubes_adjacent_factor(inner, outer_edge);
}

constexpr std::array families{
    SceneFamily{"squares_blocked", "edge of the square in the middle", 0, 1, 0.5, scenes::squares_blocked,
                [](double edge, int from, int to) { return of_pair(squares_blocked_factor(edge), from, to); }},
    SceneFamily{"squares_through_aperture", "edge of the hole", 0, 1, 0.5, scenes::squares_through_aperture,
                [](double edge, int from, int to) { return of_pair(squares_through_aperture_factor(edge), from, to); }},
    SceneFamily{"l_shaped_room", "depth of the second leg behind the corner", least_depth, most_depth, 2,
                scenes::l_shaped_room, l_shaped_room},
    SceneFamily{"nested_cubes", "edge of the inner cube", least_inner_edge, most_inner_edge, 2, scenes::nested_cubes,
                nested_cubes},
};

constexpr std::string_view prefix = "configuration ";

const SceneFamily* find_family(std::string_view name) {
    const auto* const found =
        std::find_if(families.begin(), families.end(), [&](const SceneFamily& f) { return f.name == name; });
    return found == families.end() ? nullptr : found;
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
            throw UserError("scene {} (a box needs three numbers, box:AxBxC). Try box:2x1x0.5.", excerpt(name));
        }
        scene = make_box((*edges)[0], (*edges)[1], (*edges)[2]);
    } else {
        auto configuration = family_scene(name);
        if (!configuration) configuration = configuration_scene(name);
        if (!configuration) {
            throw UserError(
                "scene {} (unknown; built in are cube, box:AxBxC and those that 'ffstudy list "
                "scenes' shows). {}",
                excerpt(name), suggestion(name));
        }
        scene = std::move(*configuration);
    }
    scene.name = name;
    return scene;
}

std::span<const SceneFamily> scene_families() {
    return families;
}

std::optional<Scene> family_scene(std::string_view name) {
    const std::size_t colon = name.find(':');
    const SceneFamily* family = find_family(name.substr(0, colon));
    if (family == nullptr || colon == std::string_view::npos) return std::nullopt;
    const auto measure = parse_bare_number<double>(name.substr(colon + 1));
    const auto refuse = [&](std::string_view why) {
        throw UserError("scene {} ({}). Try {}:{}.", excerpt(name), why, family->name, family->of_catalogue);
    };
    if (!measure) refuse(fmt::format("behind the colon stands the {}, a number", family->measure));
    // Written so that NaN fails as well.
    if (!(*measure >= family->least && *measure <= family->most))
        refuse(fmt::format("the {} may be from {} to {}", family->measure, family->least, family->most));
    Scene scene = family->scene(*measure);
    scene.name = name;
    scene.canonical = *measure == family->of_catalogue ? fmt::format("{}{}", prefix, family->name)
                                                       : fmt::format("{}{} {}", prefix, family->name, *measure + 0.0);
    return scene;
}

std::optional<FamilyMember> family_member(const Scene& scene) {
    std::string_view text = scene.canonical;
    if (!text.starts_with(prefix)) return std::nullopt;
    text.remove_prefix(prefix.size());
    const std::size_t space = text.find(' ');
    const SceneFamily* family = find_family(text.substr(0, space));
    if (family == nullptr) return std::nullopt;
    if (space == std::string_view::npos) return FamilyMember{family, family->of_catalogue};
    return FamilyMember{family, parse_bare_number<double>(text.substr(space + 1)).value()};
}

}  // namespace ff

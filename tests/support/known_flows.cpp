#include "tests/support/known_flows.hpp"

#include "core/configurations/closed_forms.hpp"
#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace ff::studies::heat {
namespace {

constexpr std::string_view annulus = R"(closed = true
[[surface]]
face = "inner"
shape = "cylinder"
base = [0, 0, 0]
axis = [0, 0, 2]
radius = 1
facing = "outward"
[[surface]]
face = "outer"
shape = "cylinder"
base = [0, 0, 0]
axis = [0, 0, 2]
radius = 2
facing = "inward"
[[surface]]
face = "bottom"
shape = "disc"
centre = [0, 0, 0]
normal = [0, 0, 1]
radius = 2
inner_radius = 1
[[surface]]
face = "top"
shape = "disc"
centre = [0, 0, 2]
normal = [0, 0, -1]
radius = 2
inner_radius = 1
)";

constexpr std::string_view furnace = R"(# closed
v 0 0 0
v 4 0 0
v 4 3 0
v 0 3 0
v 0 0 2.5
v 4 0 2.5
v 4 3 2.5
v 0 3 2.5
v 1.5 1 0
v 2.5 1 0
v 2.5 2 0
v 1.5 2 0
v 1.5 1 1.5
v 2.5 1 1.5
v 2.5 2 1.5
v 1.5 2 1.5
g floor
f 1 2 10 9
f 2 3 11 10
f 3 4 12 11
f 4 1 9 12
g roof
f 5 8 7 6
g south
f 1 5 6 2
g east
f 2 6 7 3
g north
f 3 7 8 4
g west
f 4 8 5 1
g block
f 9 10 14 13
f 10 11 15 14
f 11 12 16 15
f 12 9 13 16
f 13 14 15 16
)";

constexpr std::string_view materials_of_furnace = R"([materials]
block = { emissivity = 0.8, temperature = 1200 }
roof = { emissivity = 0.6, temperature = 400 }
"*" = { emissivity = 0.9, flux = 0 }
)";

}  // namespace

Scene annulus_scene() {
    return make_scene(source_of_file("annulus.toml", annulus));
}

double annulus_factor(int from, int to) {
    constexpr double inner_area = 4 * std::numbers::pi;
    constexpr double outer_area = 8 * std::numbers::pi;
    constexpr double end_area = 3 * std::numbers::pi;
    const auto outer_to_inner = static_cast<double>(outer_cylinder_to_inner_factor(1, 2, 2));
    const auto outer_to_outer = static_cast<double>(outer_cylinder_to_itself_factor(1, 2, 2));
    const double inner_to_outer = outer_to_inner * outer_area / inner_area;
    const double inner_to_end = (1 - inner_to_outer) / 2;
    const double outer_to_end = (1 - outer_to_inner - outer_to_outer) / 2;
    const double end_to_inner = inner_to_end * inner_area / end_area;
    const double end_to_outer = outer_to_end * outer_area / end_area;
    const double end_to_end = 1 - end_to_inner - end_to_outer;
    const std::array<std::array<double, 4>, 4> factors{{{0, inner_to_outer, inner_to_end, inner_to_end},
                                                        {outer_to_inner, outer_to_outer, outer_to_end, outer_to_end},
                                                        {end_to_inner, end_to_outer, 0, end_to_end},
                                                        {end_to_inner, end_to_outer, end_to_end, 0}}};
    return factors.at(static_cast<std::size_t>(from)).at(static_cast<std::size_t>(to));
}

double cube_factor(int from, int to) {
    if (from == to) return 0;
    const double root = std::numbers::sqrt2;
    const double opposite = 2 / std::numbers::pi * (std::log(4. / 3) / 2 + 2 * root * std::atan(1 / root)) - 1;
    // In the paper's numbering of faces from 1 to 6, faces 1 and 6, 2 and 3, 4 and 5 are opposite.
    constexpr std::array<int, 6> opposites{5, 2, 1, 4, 3, 0};
    return opposites.at(static_cast<std::size_t>(from)) == to ? opposite : (1 - opposite) / 4;
}

Scene furnace_scene() {
    return make_scene(source_of_file("furnace.obj", furnace));
}

Materials furnace_materials() {
    return read_materials(materials_of_furnace, "materials.toml", {furnace_scene().faces, {}});
}

stats::Proportion furnace_walks() {
    return {.hits = 612'118'783, .trials = 1'000'000'000};
}

Bounds furnace_power() {
    constexpr double level = 1 - 1e-6;
    constexpr double area = 7;
    constexpr double emissivity = 0.8;
    const stats::Interval share = stats::clopper_pearson_interval(furnace_walks(), level);
    const double difference = stefan_boltzmann * (std::pow(1200, 4) - std::pow(400, 4));
    return {area * emissivity * difference * share.low, area * emissivity * difference * share.high};
}

}  // namespace ff::studies::heat

#include "core/configurations/catalogue.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/closed_forms.hpp"
#include "core/configurations/scenes.hpp"
#include "core/formulas/rectangle_formulas.hpp"
#include "core/geometry/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace ff {
namespace {

using enum ConfigurationKind;
namespace scenes = configuration_scenes;

/// Identical rectangles x by y, opposite each other.
long double opposite_rectangles(long double x, long double y, long double gap) {
    return parallel_exchange_area<long double>({0, x}, {0, y}, {0, x}, {0, y}, gap) / (x * y);
}

/// Rectangles at right angles with a common edge of length 1, `from` and `to` wide.
long double perpendicular_rectangles(long double from, long double to) {
    return perpendicular_exchange_area<long double>({0, 1}, {0, 1}, {0, from}, {0, to}) / from;
}

constexpr std::array catalogue{
    Configuration{"R01", "cube_opposite_faces", "opposite faces of a cube", "C-11 with X = Y = 1", "howell", surfaces,
                  false, [] { return opposite_rectangles(1, 1, 1); },
                  [] { return scenes::parallel_rectangles(1, 1, 1); }},
    Configuration{"R02", "cube_adjacent_faces", "adjacent faces of a cube", "C-14 with H = W = 1", "howell", surfaces,
                  false, [] { return perpendicular_rectangles(1, 1); },
                  [] { return scenes::rectangles_at_angle(1, 1, 1, 90); }},
    Configuration{"R03", "parallel_rectangles", "parallel 2 x 1 rectangles, 1 apart", "C-11 with X = 2, Y = 1",
                  "howell", surfaces, false, [] { return opposite_rectangles(2, 1, 1); },
                  [] { return scenes::parallel_rectangles(2, 1, 1); }},
    Configuration{"R04", "parallel_squares_close", "parallel squares, a tenth of their side apart",
                  "C-11 with X = Y = 10", "howell", surfaces, false, [] { return opposite_rectangles(10, 10, 1); },
                  [] { return scenes::parallel_rectangles(10, 10, 1); }},
    Configuration{"R05", "parallel_squares_far", "parallel squares, ten times their side apart",
                  "C-11 with X = Y = 0.1", "howell", surfaces, false, [] { return opposite_rectangles(1, 1, 10); },
                  [] { return scenes::parallel_rectangles(1, 1, 10); }},
    Configuration{"R07", "perpendicular_rectangles",
                  "1 x 0.5 rectangle to a perpendicular 1 x 2 one, the edge of 1 in common", "C-14 with W = 0.5, H = 2",
                  "howell", surfaces, false, [] { return perpendicular_rectangles(0.5L, 2); },
                  [] { return scenes::rectangles_at_angle(1, 0.5, 2, 90); }},
    Configuration{"R09a", "squares_at_60_degrees", "unit squares with a common edge, 60 degrees between them",
                  "C-16, as a contour integral", "howell", surfaces, false,
                  [] { return rectangles_at_angle_factor(1, 1, 1, std::numbers::pi_v<long double> / 3); },
                  [] { return scenes::rectangles_at_angle(1, 1, 1, 60); }},
    Configuration{"R10", "tetrahedron", "two faces of a regular tetrahedron",
                  "contour integral; 1/3 by symmetry and closure", "sparrow1963", surfaces, false, tetrahedron_factor,
                  scenes::tetrahedron},
    Configuration{"R11", "parallel_right_triangles", "the same half of two opposite faces of a unit cube",
                  "contour integral", "sparrow1963", surfaces, false, parallel_right_triangles_factor,
                  scenes::parallel_right_triangles},
    Configuration{"R13", "coaxial_discs_equal", "coaxial discs of radius 1, 1 apart", "C-41 with R1 = R2 = 1", "howell",
                  surfaces, false, [] { return coaxial_discs_factor(1, 1, 1); },
                  [] { return scenes::coaxial_discs(1, 1, 1); }},
    Configuration{"R14", "coaxial_discs_unequal", "disc of radius 1 to a coaxial one of radius 2, 1 apart",
                  "C-41 with R1 = 1, R2 = 2", "howell", surfaces, false, [] { return coaxial_discs_factor(1, 2, 1); },
                  [] { return scenes::coaxial_discs(1, 2, 1); }},
    Configuration{"R15", "element_to_disc", "element of area to a coaxial disc of radius 1, 1 apart", "B-12", "howell",
                  element, false, [] { return element_to_disc_factor(1, 1); }},
    Configuration{"R16", "element_to_square",
                  "element of area to a parallel unit square above it, corner on its normal", "B-4", "howell", element,
                  false, [] { return element_to_rectangle_factor(1, 1, 1); }},
    Configuration{"R17", "sphere_to_disc", "sphere to a coaxial disc of radius 1, its centre 2 away",
                  "(1 - 1/sqrt(1 + (r/h)^2)) / 2, for every sphere that does not reach the disc's plane", "howell",
                  surfaces, false, [] { return sphere_to_disc_factor(1, 2); }, scenes::sphere_to_disc},
    Configuration{"R20", "cylinder_wall", "wall of a cylinder of radius 1 and height 2, to itself",
                  "1 + H - sqrt(1 + H^2) with H = h / 2r = 1", "howell", surfaces, false,
                  [] { return cylinder_wall_to_itself_factor(1, 2); }, scenes::cylinder_wall, 0, 0},
    Configuration{"R21", "cylinder_base_to_wall", "base of a cylinder of radius 1 and height 2, to its wall",
                  "2 H / (H + sqrt(1 + H^2)) with H = h / 2r = 1", "howell", surfaces, false,
                  [] { return cylinder_base_to_wall_factor(1, 2); }, scenes::cylinder_base},
    Configuration{"R22", "sphere_caps", "cap of height 0.5 of a sphere of radius 1, to the opposite one, inside",
                  "h / 2R, the share of the sphere's area", "howell", surfaces, false,
                  [] { return sphere_cap_factor(1, 0.5L); }, scenes::sphere_caps},
    Configuration{"R23", "hemisphere", "inside of a hemisphere, to itself", "h / 2R with h = R", "howell", surfaces,
                  false, [] { return sphere_cap_factor(1, 1); }, scenes::hemisphere, 0, 0},
    Configuration{"R24", "cone_wall", "wall of a cone of radius 1 and height 1, to itself, inside",
                  "1 - r / sqrt(r^2 + h^2)", "howell", surfaces, false, [] { return cone_wall_to_itself_factor(1, 1); },
                  scenes::cone_wall, 0, 0},
    Configuration{"R27", "wedge", "infinite plates of equal width, at right angles", "1 - sin(angle / 2)", "hottel1954",
                  endless, false, [] { return wedge_factor(std::numbers::pi_v<long double> / 2); }},
    Configuration{"R29", "plane_to_tubes", "infinite plane to a row of tubes, axes two diameters apart",
                  "1 - sqrt(1 - D^2) + D acos(D) with D = 0.5; the tubes shade each other", "hottel1954", endless, true,
                  [] { return plane_to_tubes_factor(0.5L); }},
    Configuration{"O01", "squares_blocked",
                  "opposite unit squares 1 apart, with a square of side 0.5 in the middle between them",
                  "C-11 less what an aperture lets through", "ehlert1993", surfaces, true,
                  [] { return squares_blocked_factor(0.5L); }, [] { return scenes::squares_blocked(0.5); }},
    Configuration{"O01c", "squares_through_aperture",
                  "opposite unit squares 1 apart, through a square hole of side 0.5 in a plate between them",
                  "piecewise linear cross-sections, integrated against the corner function of C-13", "ehlert1993",
                  surfaces, true, [] { return squares_through_aperture_factor(0.5L); },
                  [] { return scenes::squares_through_aperture(0.5); }},
    Configuration{"O03", "l_shaped_room",
                  "long wall of 3 x 3 to the far short wall of 1 x 3 of an L-shaped room, past the corner",
                  "as through an aperture, the mouth of the leg", "ehlert1993", surfaces, true,
                  [] { return l_shaped_room_exchange_area(2) / 9; }, [] { return scenes::l_shaped_room(2); }},
    Configuration{"O05", "concentric_spheres", "sphere of radius 2, inside, to itself past one of radius 1",
                  "1 - (r1 / r2)^2, by reciprocity and closure", "howell", surfaces, true,
                  [] { return outer_sphere_to_itself_factor(1, 2); }, scenes::concentric_spheres, 0, 0},
    Configuration{"O08", "discs_blocked",
                  "disc of radius 0.5 to a coaxial one of radius 1, 1 apart, past one of radius 0.25 halfway",
                  "difference of two C-41; all of the blocker's shadow falls on the second disc", "howell", surfaces,
                  true,
                  [] {
                      return blocked_coaxial_discs_factor(0.5L, 1, 1, {0.25L, 0.5L});
                  },
                  scenes::discs_blocked},
    Configuration{"O11a", "nested_cubes_opposite", "opposite faces of a cube of 6, past a cube of 2 in its middle",
                  "closed form, and Gauss's rule for the corners of the shadow", "ehlert1993", surfaces, true,
                  [] { return nested_cubes_opposite_factor(2, 6); }, [] { return scenes::nested_cubes(2); }, 0, 2,
                  "nested_cubes"},
    Configuration{"O11b", "nested_cubes_adjacent", "adjacent faces of a cube of 6, past a cube of 2 in its middle",
                  "closure: a face sends 1/9 to the inner cube", "ehlert1993", surfaces, true,
                  [] { return nested_cubes_adjacent_factor(2, 6); }, [] { return scenes::nested_cubes(2); }, 0, 1,
                  "nested_cubes"},
};

/// Names the scene in the random streams.
std::string canonical_text(const Configuration& configuration) {
    return fmt::format("configuration {}", configuration.scene_name);
}

}  // namespace

std::span<const Configuration> configurations() {
    return catalogue;
}

bool is_configuration(const Scene& scene, const Configuration& configuration) {
    return configuration.scene != nullptr && scene.canonical == canonical_text(configuration);
}

std::optional<Scene> configuration_scene(std::string_view name) {
    for (const Configuration& configuration : catalogue) {
        if (configuration.scene == nullptr || configuration.scene_name != name) continue;
        Scene scene = configuration.scene();
        scene.name = name;
        scene.canonical = canonical_text(configuration);
        return scene;
    }
    return std::nullopt;
}

int other_faces(const Scene& scene, const Configuration& configuration) {
    return configuration.from == configuration.to ? static_cast<int>(scene.faces.size()) - 1 : 0;
}

std::vector<std::string_view> configuration_scene_names() {
    std::vector<std::string_view> names;
    for (const Configuration& configuration : catalogue) {
        const bool known = std::find(names.begin(), names.end(), configuration.scene_name) != names.end();
        if (configuration.scene != nullptr && !known) names.push_back(configuration.scene_name);
    }
    return names;
}

std::optional<double> known_form_factor(const Scene& scene, int from_face, int to_face) {
    if (const auto member = family_member(scene)) {
        const auto factor = member->family->exact(member->measure, from_face, to_face);
        return factor ? std::optional(static_cast<double>(*factor)) : std::nullopt;
    }
    for (const Configuration& configuration : catalogue) {
        if (!is_configuration(scene, configuration)) continue;
        const int from = configuration.from;
        const int to = configuration.to;
        if (from_face == from && to_face == to) return static_cast<double>(configuration.exact());
        const int others = other_faces(scene, configuration);
        const long double factor = others == 0 ? configuration.exact() : (1 - configuration.exact()) / others;
        const auto is_pair = [&](int a, int b) { return a == from && (others == 0 ? b == to : b != from); };
        if (is_pair(from_face, to_face)) return static_cast<double>(factor);
        if (is_pair(to_face, from_face))
            return static_cast<double>(factor * face_area(scene, from) / face_area(scene, from_face));
    }
    return std::nullopt;
}

std::string_view why_no_scene(ConfigurationKind kind) {
    switch (kind) {
        case surfaces:
            break;
        case element:
            return "a differential area has no points to start rays from, and estimates are of finite surfaces";
        case endless:
            return "scenes are three-dimensional and finite; cut off somewhere it would be another configuration";
    }
    return "";
}

}  // namespace ff

#include "studies/scene_files/scene_writer.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/formats.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

bool is_a_word(const std::string& name) {
    return !name.empty() && name != occluder_group && name.find_first_of(" \t\r\n#") == std::string::npos;
}

/// Calls `write(surface)` for the surfaces of one face after the other; those of no face come last.
template <class Write>
void by_faces(const Scene& scene, const Write& write) {
    std::vector<const Surface*> surfaces;
    for (const Surface& surface : scene.surfaces) surfaces.push_back(&surface);
    const auto rank = [&](const Surface* surface) {
        return surface->face == no_face ? scene.faces.size() : static_cast<std::size_t>(surface->face);
    };
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [&](const Surface* a, const Surface* b) { return rank(a) < rank(b); });
    for (const Surface* surface : surfaces) write(*surface);
}

std::string vector_text(const Vector3d& v) {
    return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

/// Keys of a flat surface: `shape` and whether it radiates to the other side of what they say.
std::string flat_keys(std::string_view keys, const Surface& surface, const Vector3d& upwards) {
    return fmt::format("{}{}", keys, upwards.dot(surface.normal) < 0 ? "flip = true\n" : "");
}

std::string keys_of(const Surface& surface) {
    return std::visit(
        [&](const auto& shape) -> std::string {
            using T = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<T, Parallelogram>) {
                return flat_keys(
                    fmt::format("shape = \"parallelogram\"\ncorner = {}\nedge_u = {}\nedge_v = {}\n",
                                vector_text(shape.corner), vector_text(shape.edge_u), vector_text(shape.edge_v)),
                    surface, shape.edge_u.cross(shape.edge_v));
            } else if constexpr (std::is_same_v<T, Triangle>) {
                return flat_keys(fmt::format("shape = \"triangle\"\na = {}\nb = {}\nc = {}\n", vector_text(shape.a),
                                             vector_text(shape.b), vector_text(shape.c)),
                                 surface, (shape.b - shape.a).cross(shape.c - shape.a));
            } else if constexpr (std::is_same_v<T, Disc>) {
                return fmt::format("shape = \"disc\"\ncentre = {}\nnormal = {}\nradius = {}\ninner_radius = {}\n",
                                   vector_text(shape.centre), vector_text(surface.normal), shape.outer_radius,
                                   shape.inner_radius);
            } else if constexpr (std::is_same_v<T, Frustum>) {
                return fmt::format(
                    "shape = \"cone\"\nbase = {}\naxis = {}\nbase_radius = {}\ntop_radius = {}\nfacing = \"{}\"\n",
                    vector_text(shape.base), vector_text(shape.axis), shape.base_radius, shape.top_radius,
                    name(shape.facing));
            } else {
                return fmt::format(
                    "shape = \"sphere\"\ncentre = {}\naxis = {}\nradius = {}\nlow = {}\nhigh = {}\nfacing = \"{}\"\n",
                    vector_text(shape.centre), vector_text(shape.axis), shape.radius, shape.low * shape.radius,
                    shape.high * shape.radius, name(shape.facing));
            }
        },
        surface.shape);
}

}  // namespace

bool is_of_polygons(const Scene& scene) {
    return std::all_of(scene.faces.begin(), scene.faces.end(), is_a_word) &&
           std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const Surface& surface) { return is_polygon(surface.shape); });
}

std::string obj_text(const Scene& scene) {
    std::string text = scene.closed ? "# closed\n" : "";
    std::string group;
    std::size_t vertex = 0;
    by_faces(scene, [&](const Surface& surface) {
        const std::string name =
            surface.face == no_face ? std::string(occluder_group) : scene.faces[static_cast<std::size_t>(surface.face)];
        if (name != group) text += fmt::format("g {}\n", name);
        group = name;
        std::string polygon = "f";
        for (const Vector3d& corner : outline(surface)) {
            text += fmt::format("v {} {} {}\n", corner.x(), corner.y(), corner.z());
            polygon += fmt::format(" {}", ++vertex);
        }
        text += polygon + "\n";
    });
    return text;
}

std::string vs3_text(const Scene& scene) {
    return vs3_text(scene, std::vector<std::optional<double>>(scene.faces.size()));
}

std::string vs3_text(const Scene& scene, const std::vector<std::optional<double>>& emissivities) {
    std::string text = fmt::format("T {}\nC encl={}\nF 3\n", scene.name, scene.closed ? 1 : 0);
    std::string surfaces;
    std::vector<std::size_t> first(scene.faces.size());  // surface of a face; 0: none so far
    std::size_t vertex = 0;
    std::size_t number = 0;
    by_faces(scene, [&](const Surface& surface) {
        std::array<std::size_t, 4> indices{};
        std::size_t at = 0;
        for (const Vector3d& corner : outline(surface)) {
            text += fmt::format("V {} {} {} {}\n", ++vertex, corner.x(), corner.y(), corner.z());
            indices.at(at++) = vertex;
        }
        ++number;
        if (surface.face == no_face) {
            surfaces += fmt::format("O {} {} 0 0 0 {}\n", number, fmt::join(indices, " "), occluder_group);
            return;
        }
        const auto face = static_cast<std::size_t>(surface.face);
        surfaces += fmt::format("S {} {} 0 {} {} {}\n", number, fmt::join(indices, " "), first[face],
                                emissivities[face].value_or(0.5), scene.faces[face]);
        if (first[face] == 0) first[face] = number;
    });
    return text + surfaces + "End of data\n";
}

std::string toml_scene_text(const Scene& scene) {
    std::string text = scene.closed ? "closed = true\n" : "";
    by_faces(scene, [&](const Surface& surface) {
        text += "\n[[surface]]\n" + keys_of(surface);
        if (surface.face != no_face)
            text += fmt::format("face = {}\n", toml_text(scene.faces[static_cast<std::size_t>(surface.face)]));
        if (surface.grid != undivided)
            text += fmt::format("grid = [{}, {}]\n", surface.grid.columns, surface.grid.rows);
    });
    return text;
}

}  // namespace ff::studies

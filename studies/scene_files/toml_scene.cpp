#include "studies/readers/toml_reader.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <array>
#include <string>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using Names = std::vector<std::string_view>;

constexpr std::uint64_t most_parts = 1024;

Vector3d vector(const TomlReader& reader, std::string_view key) {
    const std::vector<double> numbers = reader.numbers(key);
    if (numbers.size() != 3) reader.fail(key, "(expected three coordinates). Write [1, 0, 0.5].");
    return {numbers[0], numbers[1], numbers[2]};
}

Vector3d direction(const TomlReader& reader, std::string_view key) {
    Vector3d v = vector(reader, key);
    if (!(v.norm() > 0)) reader.fail(key, "(a direction has a length). Write [0, 0, 1].");
    return v;
}

double length(const TomlReader& reader, std::string_view key) {
    const auto value = reader.optional_number(key);
    if (!value) reader.fail(key, "missing. Add the key with a length.");
    if (*value < 0) reader.fail(key, "(a length is not negative). Take its absolute value.");
    return *value;
}

bool flag(const TomlReader& reader, std::string_view key) {
    const toml::node* node = reader.find(key);
    if (node == nullptr) return false;
    const auto value = node->value_exact<bool>();
    if (!value) reader.fail(key, "(not true or false). Write true.");
    return *value;
}

Facing read_facing(const TomlReader& reader) {
    if (!reader.has("facing"))
        reader.fail("facing", R"(missing (a round surface radiates on one side). Say "inward" or "outward".)");
    return reader.choice<Facing>("facing");
}

/// Refuses other keys than those of every surface and `own`.
void expect_only(const TomlReader& reader, Names own) {
    own.insert(own.end(), {"shape", "face", "grid"});
    reader.expect_only(own);
}

/// Parts along s, and along t.
Grid read_grid(const TomlReader& reader) {
    if (!reader.has("grid")) return undivided;
    const std::vector<std::uint64_t> parts = reader.counts("grid");
    if (parts.size() != 2) reader.fail("grid", "(expected parts along s and along t). Write [4, 1].");
    for (const std::uint64_t count : parts) {
        if (count < 1 || count > most_parts)
            reader.fail("grid", fmt::format("(a surface has 1 to {} parts each way). Write [4, 1].", most_parts));
    }
    return {static_cast<std::uint32_t>(parts[0]), static_cast<std::uint32_t>(parts[1])};
}

Surface flat_surface(const TomlReader& reader, Shape shape, const Vector3d& upwards) {
    const Vector3d normal = upwards.normalized();
    return {std::move(shape), flag(reader, "flip") ? Vector3d(-normal) : normal, 0};
}

Surface curved_surface(Shape shape) {
    return {std::move(shape), Vector3d::Zero(), 0};
}

Surface read_frustum(const TomlReader& reader, double base_radius, double top_radius) {
    const Vector3d axis = direction(reader, "axis");
    return curved_surface(Frustum{vector(reader, "base"), axis, base_radius, top_radius, read_facing(reader)});
}

/// Part of a sphere between two heights above its centre.
Surface read_zone(const TomlReader& reader) {
    expect_only(reader, {"centre", "radius", "facing", "axis", "low", "high"});
    const double radius = length(reader, "radius");
    if (!(radius > 0)) reader.fail("radius", "(a sphere has one). Give a positive length.");
    const double low = reader.optional_number("low").value_or(-radius) / radius;
    const double high = reader.optional_number("high").value_or(radius) / radius;
    if (low < -1 || high > 1 || low >= high) {
        reader.fail(reader.has("low") ? "low" : "high",
                    "(heights above the centre rise from -radius to radius). Take low below high.");
    }
    const bool whole = low == -1 && high == 1;
    const Vector3d axis = whole && !reader.has("axis") ? Vector3d(0, 0, 1) : direction(reader, "axis").normalized();
    return curved_surface(SphereZone{vector(reader, "centre"), axis, radius, low, high, read_facing(reader)});
}

Surface read_surface(const TomlReader& reader) {
    static constexpr std::array<std::string_view, 6> shapes{"parallelogram", "triangle", "disc",
                                                            "cylinder",      "cone",     "sphere"};
    switch (reader.index_of("shape", shapes)) {
        case 0: {
            expect_only(reader, {"corner", "edge_u", "edge_v", "flip"});
            const Vector3d u = direction(reader, "edge_u");
            const Vector3d v = direction(reader, "edge_v");
            return flat_surface(reader, Parallelogram{vector(reader, "corner"), u, v}, u.cross(v));
        }
        case 1: {
            expect_only(reader, {"a", "b", "c", "flip"});
            const Vector3d a = vector(reader, "a");
            const Vector3d b = vector(reader, "b");
            const Vector3d c = vector(reader, "c");
            return flat_surface(reader, Triangle{a, b, c}, (b - a).cross(c - a));
        }
        case 2: {
            expect_only(reader, {"centre", "normal", "radius", "inner_radius", "flip"});
            const double outer = length(reader, "radius");
            if (outer == 0) reader.fail("radius", "(not positive: no area). Make it larger.");
            const double inner = reader.has("inner_radius") ? length(reader, "inner_radius") : 0;
            if (inner >= outer)
                reader.fail("inner_radius", "(not below the radius: nothing is left). Make it smaller.");
            return flat_surface(reader, Disc{vector(reader, "centre"), inner, outer}, direction(reader, "normal"));
        }
        case 3: {
            expect_only(reader, {"base", "axis", "radius", "facing"});
            const double radius = length(reader, "radius");
            return read_frustum(reader, radius, radius);
        }
        case 4:
            expect_only(reader, {"base", "axis", "base_radius", "top_radius", "facing"});
            return read_frustum(reader, length(reader, "base_radius"), length(reader, "top_radius"));
        default:
            return read_zone(reader);
    }
}

}  // namespace

SceneWithMaterials read_toml_scene(std::string_view name, std::string_view text) {
    const toml::table root = parse_toml(text, name, "docs/scenes.md");
    const TomlReader file(root, name);
    file.expect_only({"closed", "surface"});
    SceneBuilder builder(name);
    for (const TomlReader& reader : file.tables("surface")) {
        Surface surface = read_surface(reader);
        const auto face = reader.optional_text("face");
        surface.face = face ? builder.face(*face, reader.line()) : no_face;
        surface.grid = read_grid(reader);
        builder.add(std::move(surface), reader.line());
    }
    return {builder.finish(flag(file, "closed")), {}};
}

}  // namespace ff::studies

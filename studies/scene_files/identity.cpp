#include "studies/scene_files/identity.hpp"

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <variant>

namespace ff::studies {

using Eigen::Vector3d;

std::vector<double> numbers_of(const Surface& surface) {
    std::vector<double> list{static_cast<double>(surface.shape.index())};
    const auto put = [&](const Vector3d& v) { list.insert(list.end(), {v.x(), v.y(), v.z()}); };
    std::vector<Vector3d> polygon = corners(surface.shape);
    std::sort(polygon.begin(), polygon.end(), [](const Vector3d& a, const Vector3d& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    for (const Vector3d& corner : polygon) put(corner);
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        put(disc->centre);
        put(surface.normal);
        list.insert(list.end(), {disc->inner_radius, disc->outer_radius});
    } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        put(wall->base);
        put(wall->axis);
        list.insert(list.end(), {wall->base_radius, wall->top_radius, static_cast<double>(wall->facing)});
    } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        put(zone->centre);
        put(zone->axis);
        list.insert(list.end(), {zone->radius, zone->low, zone->high, static_cast<double>(zone->facing)});
    }
    for (double& number : list) number += 0.0;  // -0 is 0
    list.resize(13);
    return list;
}

namespace {

constexpr std::uint64_t empty_hash = 0xcbf29ce484222325ULL;

/// FNV-1a over 64-bit words.
void mix(std::uint64_t& hash, std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
        hash ^= word >> (8 * byte) & 0xff;
        hash *= 0x100000001b3ULL;
    }
}

}  // namespace

std::uint64_t fingerprint(const Surface& surface) {
    std::uint64_t hash = empty_hash;
    for (const double number : numbers_of(surface)) mix(hash, std::bit_cast<std::uint64_t>(number));
    return hash;
}

std::string canonical_of(const Scene& scene) {
    std::uint64_t content = empty_hash;
    mix(content, scene.closed ? 1 : 0);
    for (const Surface& surface : scene.surfaces) {
        mix(content, fingerprint(surface));
        mix(content, static_cast<std::uint64_t>(surface.face));
        for (const double component : surface.normal) mix(content, std::bit_cast<std::uint64_t>(component + 0.0));
        // Scenes without grids keep the identity that they had before there were grids.
        if (surface.grid == undivided) continue;
        mix(content, surface.grid.columns);
        mix(content, surface.grid.rows);
    }
    return fmt::format("scene {:016x}", content);
}

}  // namespace ff::studies

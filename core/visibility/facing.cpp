#include "core/visibility/facing.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/touching.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace ff {
namespace {

constexpr std::size_t most_surfaces_pair_by_pair = 4096;

/// The least and the greatest height of a surface above the plane of a flat one.
Extent heights(const Surface& flat, const Surface& body) {
    const Extent own = extent(flat, flat.normal);
    const Extent other = extent(body, flat.normal);
    return {other.low - own.low, other.high - own.low};
}

bool has_some_in_front(const Surface& surface, const Surface& other) {
    return !is_flat(surface.shape) || heights(surface, other).high > 0;
}

bool is_hollow(const Surface& surface) {
    return !is_flat(surface.shape) && facing(surface.shape) == Facing::inward;
}

double summed_extents(const Surface& surface) {
    double sum = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(surface, Eigen::Vector3d::Unit(axis));
        sum += along.high - along.low;
    }
    return sum;
}

/// Where images are unknown, every face is assumed to see itself.
bool sees_itself_in_mirrors(const Scene& scene, int face) {
    if (mirrors(scene).empty()) return false;
    for (const Surface& from : scene.surfaces) {
        for (const Surface& to : scene.surfaces) {
            if (from.face != face || to.face != face) continue;
            const auto places = images(scene, to);
            if (!places || std::any_of(places->begin() + 1, places->end(),
                                       [&](const Surface& place) { return ff::face_each_other(from, place); }))
                return true;
        }
    }
    return false;
}

}  // namespace

bool face_each_other(const Surface& a, const Surface& b) {
    if (&a == &b) return is_hollow(a);
    return has_some_in_front(a, b) && has_some_in_front(b, a);
}

bool face_each_other(const Scene& scene, int from_face, int to_face) {
    const auto from = surfaces_of(scene, from_face);
    const auto to = surfaces_of(scene, to_face);
    if (from.size() * to.size() > most_surface_pairs || !mirrors(scene).empty()) return true;
    return std::any_of(from.begin(), from.end(), [&](const Surface* a) {
        return std::any_of(to.begin(), to.end(), [&](const Surface* b) { return face_each_other(*a, *b); });
    });
}

bool are_partly_behind(const Scene& scene, int from_face, int to_face) {
    const auto is_behind = [](const Surface& surface, const Surface& other) {
        if (!is_flat(surface.shape)) return false;
        const Extent above = heights(surface, other);
        return above.low < -rounding_room * std::max(1.0, above.high - above.low);
    };
    for (const Surface* a : surfaces_of(scene, from_face)) {
        for (const Surface* b : surfaces_of(scene, to_face)) {
            if (a != b && (is_behind(*a, *b) || is_behind(*b, *a))) return true;
        }
    }
    return false;
}

bool sees_itself(const Scene& scene, int face) {
    if (sees_itself_in_mirrors(scene, face)) return true;
    const auto own = surfaces_of(scene, face);
    if (std::any_of(own.begin(), own.end(), [](const Surface* surface) { return is_hollow(*surface); })) return true;
    if (own.size() > most_surfaces_pair_by_pair) return true;
    for (const Surface* a : own) {
        for (const Surface* b : own) {
            if (a < b && face_each_other(*a, *b)) return true;
        }
    }
    return false;
}

bool is_convex(const Scene& scene) {
    if (scene.surfaces.size() > most_surfaces_pair_by_pair || scene.surfaces.empty()) return false;
    double smallest = std::numeric_limits<double>::max();
    for (const Surface& surface : scene.surfaces) smallest = std::min(smallest, summed_extents(surface));
    for (const Surface& plane : scene.surfaces) {
        if (!is_flat(plane.shape)) return false;
        for (const Surface& surface : scene.surfaces) {
            if (heights(plane, surface).low < -rounding_room * smallest) return false;
        }
    }
    return true;
}

}  // namespace ff

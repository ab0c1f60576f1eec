#include "core/visibility/occlusion.hpp"

#include "core/geometry/line_meets.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_surfaces_for_blockers = 512;

struct Pair {
    const Surface& from;
    const Surface& to;
    double room;

    [[nodiscard]] Extent along(const Vector3d& direction) const {
        const Extent a = extent(from, direction);
        const Extent b = extent(to, direction);
        return {std::min(a.low, b.low), std::max(a.high, b.high)};
    }
};

double length(const Extent& extent) {
    return extent.high - extent.low;
}

/// Possible error of a computed extent of a surface: it grows with the surface, unlike what the surface may hide.
double rounding_of(const Extent& extent) {
    return 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(extent.low), std::abs(extent.high));
}

/// Whether a plane across `direction` parts a surface from both of a pair. It may reach across by a share of the pair's
/// own length, however large it is itself.
bool is_parted(const Surface& surface, const Pair& pair, const Vector3d& direction) {
    const Extent own = extent(surface, direction);
    const Extent others = pair.along(direction);
    const double room =
        pair.room * length(others) - (own.high == others.low || own.low == others.high ? 0 : rounding_of(own));
    return own.high <= others.low + room || own.low >= others.high - room;
}

/// Whether a surface lies behind a flat one, where no line from its radiating side leads.
bool is_behind(const Surface& surface, const Surface& flat, const Pair& pair) {
    if (!is_flat(flat.shape)) return false;
    const Extent own = extent(surface, flat.normal);
    const Extent plane = extent(flat, flat.normal);
    const double room = pair.room * length(pair.along(flat.normal)) - (own.high == plane.high ? 0 : rounding_of(own));
    return own.high <= plane.high + room;
}

}  // namespace

bool keeps_clear(const Surface& surface, const Surface& from, const Surface& to, double room) {
    const Pair pair{from, to, room};
    if (is_behind(surface, pair.from, pair) || is_behind(surface, pair.to, pair)) return true;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (is_parted(surface, pair, Vector3d::Unit(axis))) return true;
    }
    for (const Surface* flat : {&surface, &pair.from, &pair.to}) {
        if (is_flat(flat->shape) && is_parted(surface, pair, flat->normal)) return true;
    }
    return false;
}

std::vector<const Surface*> possible_blockers(const Scene& scene, const Surface& from, const Surface& to) {
    std::vector<const Surface*> blockers;
    for (const Surface& surface : scene.surfaces) {
        const bool is_end = &surface == &from || &surface == &to;
        const bool in_the_way =
            is_end ? &from != &to && face_each_other(surface, surface) : !keeps_clear(surface, from, to);
        if (in_the_way) blockers.push_back(&surface);
    }
    return blockers;
}

bool may_be_occluded(const Scene& scene) {
    if (scene.empty_box) return false;
    if (scene.surfaces.size() > most_surfaces_for_blockers) return true;
    for (const Surface& from : scene.surfaces) {
        if (!is_of_face(from)) continue;
        for (const Surface& to : scene.surfaces) {
            if (!is_of_face(to) || &to > &from || !face_each_other(from, to)) continue;
            if (!possible_blockers(scene, from, to).empty()) return true;
        }
    }
    return false;
}

bool may_be_occluded(const Scene& scene, int from_face, int to_face) {
    if (scene.empty_box) return false;
    if (scene.surfaces.size() > most_surfaces_for_blockers) return true;
    const std::vector<const Surface*> from = surfaces_of(scene, from_face);
    const std::vector<const Surface*> to = surfaces_of(scene, to_face);
    return std::any_of(from.begin(), from.end(), [&](const Surface* a) {
        return std::any_of(to.begin(), to.end(), [&](const Surface* b) {
            return face_each_other(*a, *b) && !possible_blockers(scene, *a, *b).empty();
        });
    });
}

bool may_be_seen_in_part(const Scene& scene, int from_face, int to_face) {
    return may_be_occluded(scene, from_face, to_face) || are_partly_behind(scene, from_face, to_face);
}

bool sees(const Vector3d& place, const Surface& from, const Vector3d& other, const Surface& to,
          const std::vector<const Surface*>& blockers) {
    const Line line{place, other - place};
    return std::none_of(blockers.begin(), blockers.end(), [&](const Surface* blocker) {
        const auto meeting = line_meets(line, *blocker, {.begins = blocker == &from, .ends = blocker == &to});
        return meeting && meeting->time < 1;
    });
}

}  // namespace ff

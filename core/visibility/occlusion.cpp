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

double length(const Extent& extent) {
    return extent.high - extent.low;
}

Extent merged(const Extent& a, const Extent& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Possible error of a computed extent of a surface: it grows with the surface, unlike what the surface may hide.
double rounding_of(const Extent& extent) {
    return 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(extent.low), std::abs(extent.high));
}

/// Whether a plane across a direction parts a surface from both of a pair, given how far each reaches along it.
bool are_parted(const Extent& own, const Extent& others) {
    const double room =
        rounding_room * length(others) - (own.high == others.low || own.low == others.high ? 0 : rounding_of(own));
    return own.high <= others.low + room || own.low >= others.high - room;
}

}  // namespace

LinesBetween::LinesBetween(const Surface& from, const Surface& to)
    : from_(from), to_(to), box_(box_around(from).merged(box_around(to))) {
    const auto front = [this](const Surface& end) -> std::optional<Front> {
        if (!is_flat(end.shape)) return std::nullopt;
        return Front{end.normal, extent(end, end.normal).high, along(end.normal)};
    };
    fronts_ = {front(from), front(to)};
}

Extent LinesBetween::along(const Vector3d& direction) const {
    return merged(extent(from_, direction), extent(to_, direction));
}

bool LinesBetween::keep_clear_of(const Surface& surface) const {
    const Eigen::AlignedBox3d box = box_around(surface);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (are_parted({box.min()[axis], box.max()[axis]}, {box_.min()[axis], box_.max()[axis]})) return true;
    }
    if (is_flat(surface.shape) && are_parted(extent(surface, surface.normal), along(surface.normal))) return true;
    return std::ranges::any_of(fronts_, [&](const std::optional<Front>& front) {
        if (!front) return false;
        const Extent own = extent(surface, front->normal);
        // Behind a flat surface, no line leads from its radiating side.
        const double room = rounding_room * length(front->both) - (own.high == front->plane ? 0 : rounding_of(own));
        return own.high <= front->plane + room || are_parted(own, front->both);
    });
}

std::vector<const Surface*> possible_blockers(const Scene& scene, const Surface& from, const Surface& to) {
    std::vector<const Surface*> blockers;
    const LinesBetween lines(from, to);
    for (const Surface& surface : scene.surfaces) {
        const bool is_end = &surface == &from || &surface == &to;
        const bool in_the_way =
            is_end ? &from != &to && face_each_other(surface, surface) : !lines.keep_clear_of(surface);
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

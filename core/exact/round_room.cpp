#include "core/exact/round_room.hpp"

#include "core/configurations/closed_forms.hpp"
#include "core/support/overloaded.hpp"
#include "core/visibility/mirrors.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr double tolerance = 1e-12;  // of the room's size, and of angles
constexpr std::size_t most_rings = 64;

/// A circle around the axis.
struct Rim {
    long double height = 0;
    long double radius = 0;
};

/// What a surface is in a plane through the axis: a line that climbs it, with the room on its left. Directions are
/// angles, 0 away from the axis and pi towards it.
struct Profile {
    Rim from, to;
    double direction_from = 0, direction_to = 0;
    Eigen::Index surface = 0;
};

struct Axis {
    Vector3d origin, direction;
};

Axis axis_of(const Shape& shape) {
    return std::visit(Overloaded{[](const Disc& disc) {
                                     return Axis{disc.centre, Vector3d::Zero()};
                                 },
                                 [](const Frustum& wall) {
                                     return Axis{wall.base, wall.axis.normalized()};
                                 },
                                 [](const SphereZone& zone) {
                                     return Axis{zone.centre, zone.axis};
                                 },
                                 [](const auto&) {
                                     return Axis{Vector3d::Zero(), Vector3d::Zero()};
                                 }},
                      shape);
}

/// +1 or -1 where a direction lies along the axis or against it, 0 elsewhere.
int sense(const Axis& axis, const Vector3d& direction) {
    if (direction.cross(axis.direction).norm() > tolerance) return 0;
    return direction.dot(axis.direction) > 0 ? 1 : -1;
}

long double height_on(const Axis& axis, const Vector3d& place) {
    return (place - axis.origin).dot(axis.direction);
}

bool lies_on(const Axis& axis, const Vector3d& place, double size) {
    return (place - axis.origin).cross(axis.direction).norm() <= tolerance * size;
}

std::optional<Profile> profile(const Surface& surface, const Axis& axis, double size) {
    const Axis own = axis_of(surface.shape);
    const bool flat = is_flat(surface.shape);
    const int up = sense(axis, flat ? surface.normal : own.direction);
    if (up == 0 || !lies_on(axis, own.origin, size)) return std::nullopt;
    if (!flat && facing(surface.shape) != Facing::inward) return std::nullopt;
    Profile result;
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        const long double height = height_on(axis, disc->centre);
        result.from = {height, disc->inner_radius};
        result.to = {height, disc->outer_radius};
        if (up < 0) result.direction_from = result.direction_to = std::numbers::pi;
    } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        result.from = {height_on(axis, wall->base), wall->base_radius};
        result.to = {height_on(axis, wall->base + wall->axis), wall->top_radius};
        const double climb = std::atan2(wall->axis.norm(), up * (wall->top_radius - wall->base_radius));
        result.direction_from = result.direction_to = climb;
    } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        const auto rim = [&](long double share) {
            return Rim{height_on(axis, zone->centre) + up * share * zone->radius,
                       zone->radius * std::sqrt((1 - share) * (1 + share))};
        };
        result.from = rim(zone->low);
        result.to = rim(zone->high);
        result.direction_from = std::acos(-up * (up > 0 ? zone->low : zone->high));
        result.direction_to = std::acos(-up * (up > 0 ? zone->high : zone->low));
    } else {
        return std::nullopt;
    }
    if (up < 0) std::swap(result.from, result.to);
    return result;
}

/// Where the meridian goes on from a rim. @return empty where nothing or more than one surface follows
std::optional<std::size_t> next_of(const std::vector<Profile>& profiles, const Rim& rim, double size) {
    std::optional<std::size_t> next;
    for (std::size_t k = 0; k < profiles.size(); ++k) {
        const auto off = std::hypot(profiles[k].from.height - rim.height, profiles[k].from.radius - rim.radius);
        if (off > tolerance * size) continue;
        if (next) return std::nullopt;
        next = k;
    }
    return next;
}

/// The surfaces in their order from the lower end of the axis to the upper. Empty where they do not close, or bend away
/// from the axis.
std::vector<Profile> meridian(const std::vector<Profile>& profiles, double size) {
    std::vector<Profile> ordered;
    const auto first = std::find_if(profiles.begin(), profiles.end(), [&](const Profile& p) {
        return p.from.radius <= tolerance * size && p.direction_from < std::numbers::pi / 2;
    });
    if (first == profiles.end()) return {};
    ordered.push_back(*first);
    while (ordered.size() < profiles.size()) {
        const auto next = next_of(profiles, ordered.back().to, size);
        if (!next || profiles[*next].direction_from < ordered.back().direction_to - tolerance) return {};
        ordered.push_back(profiles[*next]);
    }
    if (ordered.back().to.radius > tolerance * size) return {};
    return ordered;
}

/// What passes through the discs that two rims bound.
long double exchange(const Rim& a, const Rim& b, double size) {
    const long double smaller = std::min(a.radius, b.radius);
    if (smaller <= tolerance * size) return 0;
    const long double distance = std::abs(a.height - b.height);
    const long double disc = std::numbers::pi_v<long double> * a.radius * a.radius;
    if (distance <= tolerance * size) return std::numbers::pi_v<long double> * smaller * smaller;
    return disc * coaxial_discs_factor(a.radius, b.radius, distance);
}

}  // namespace

std::optional<Eigen::MatrixXd> round_room_exchange(const Scene& scene) {
    if (!scene.closed || scene.surfaces.empty() || scene.surfaces.size() > most_rings) return std::nullopt;
    Axis axis = axis_of(scene.surfaces.front().shape);
    if (is_flat(scene.surfaces.front().shape)) axis.direction = scene.surfaces.front().normal;
    const double size = std::sqrt(area(scene.surfaces.front().shape)) + axis.origin.norm();
    std::vector<Profile> profiles;
    for (const Surface& surface : scene.surfaces) {
        auto found = profile(surface, axis, size);
        if (!found || !is_of_face(surface)) return std::nullopt;
        found->surface = static_cast<Eigen::Index>(profiles.size());
        profiles.push_back(*found);
    }
    const std::vector<Profile> rings = meridian(profiles, size);
    if (rings.empty()) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(rings.size());
    Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(n, n);
    for (const Profile& a : rings) {
        long double left = area(scene.surfaces[static_cast<std::size_t>(a.surface)].shape);
        for (const Profile& b : rings) {
            if (a.surface == b.surface) continue;
            const bool below = &a < &b;
            const Profile& low = below ? a : b;
            const Profile& high = below ? b : a;
            const long double both = exchange(low.to, high.from, size) - exchange(low.from, high.from, size) -
                                     exchange(low.to, high.to, size) + exchange(low.from, high.to, size);
            areas(a.surface, b.surface) = static_cast<double>(std::max(0.0L, both));
            left -= both;
        }
        if (!is_flat(scene.surfaces[static_cast<std::size_t>(a.surface)].shape))
            areas(a.surface, a.surface) = static_cast<double>(std::max(0.0L, left));
    }
    return areas;
}

}  // namespace ff

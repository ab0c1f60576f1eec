#include "core/exact/coaxial_exchange.hpp"

#include "core/configurations/closed_forms.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

namespace ff {
namespace {

using Eigen::Vector3d;
using Real = long double;

/// Surfaces are about one axis, and in front of each other, if they are off by at most this share of the extent.
constexpr double tolerance = 1e-13;
/// Error of an exchange area by all that, as a share of the squared extent.
constexpr double error_by_tolerance = 1e-12;

struct Axis {
    Vector3d origin;
    Vector3d direction;
    double extent = 1;

    [[nodiscard]] double room() const { return tolerance * extent; }
    [[nodiscard]] Real height(const Vector3d& place) const { return (place - origin).dot(direction); }
};

/// A circle about the axis. The boundary of a surface runs along it in the sense of positive angles (1) or against it.
struct Rim {
    Real height = 0;
    Real radius = 0;
    int sense = 1;
};

/// A surface about the axis that radiates upwards, downwards or inwards. Of a wall or a zone the first rim is the lower
/// one, of a disc the inner one.
struct Turned {
    const Surface* surface = nullptr;
    std::array<Rim, 2> rims;
    Real middle = 0;  ///< height of a sphere's centre

    [[nodiscard]] const Disc* disc() const { return std::get_if<Disc>(&surface->shape); }
    [[nodiscard]] const SphereZone* zone() const { return std::get_if<SphereZone>(&surface->shape); }

    /// Radius of a wall, or of its continuation.
    [[nodiscard]] Real radius_at(Real height) const {
        const auto& [low, high] = rims;
        return low.radius + (high.radius - low.radius) * (height - low.height) / (high.height - low.height);
    }
};

std::optional<Axis> axis_of(const Surface& surface) {
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) return Axis{disc->centre, surface.normal};
    if (const auto* wall = std::get_if<Frustum>(&surface.shape)) return Axis{wall->base, wall->axis.normalized()};
    if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) return Axis{zone->centre, zone->axis};
    return std::nullopt;
}

/// The surface, if it is one about the axis, as if it radiated inwards unless it is flat.
std::optional<Turned> turned(const Surface& surface, const Axis& axis) {
    const auto own = axis_of(surface);
    if (!own || own->direction.cross(axis.direction).norm() > tolerance) return std::nullopt;
    if ((own->origin - axis.origin).cross(axis.direction).norm() > axis.room()) return std::nullopt;
    const int up = own->direction.dot(axis.direction) > 0 ? 1 : -1;
    const Real height = axis.height(own->origin);
    Turned result{&surface, {}, height};
    auto& [low, high] = result.rims;
    if (const auto* disc = result.disc()) {
        low = {height, disc->inner_radius, -up};
        high = {height, disc->outer_radius, up};
        return result;
    }
    if (const auto* zone = result.zone()) {
        const auto rim_at = [&](Real share) {
            return Rim{height + up * share * zone->radius, zone->radius * std::sqrt((1 - share) * (1 + share))};
        };
        low = rim_at(zone->low);
        high = rim_at(zone->high);
    } else {
        const auto& wall = std::get<Frustum>(surface.shape);
        low = {height, wall.base_radius};
        high = {axis.height(wall.base + wall.axis), wall.top_radius};
    }
    if (up < 0) std::swap(low, high);
    low.sense = -1;
    return result;
}

bool radiates_inwards(const Surface& surface) {
    return is_flat(surface.shape) || facing(surface.shape) == Facing::inward;
}

bool are_of_one_sphere(const Turned& a, const Turned& b, Real room) {
    return a.zone() != nullptr && b.zone() != nullptr && std::abs(a.middle - b.middle) <= room &&
           std::abs(Real{a.zone()->radius} - b.zone()->radius) <= room;
}

/// The largest distance of a zone from the axis, less that of a wall or of its continuation.
Real excess(const Turned& zone, const Turned& wall) {
    const Real slope = (wall.rims[1].radius - wall.rims[0].radius) / (wall.rims[1].height - wall.rims[0].height);
    const Real steepest = zone.middle - slope * zone.zone()->radius / std::sqrt(1 + slope * slope);
    const Real at = std::clamp(steepest, zone.rims[0].height, zone.rims[1].height);
    const Real off = at - zone.middle;
    const Real radius = zone.zone()->radius;
    return std::sqrt(std::max(Real{0}, (radius - off) * (radius + off))) - wall.radius_at(at);
}

/// Whether every place of a ring lies in front of every place of another.
bool is_in_front(const Turned& ring, const Turned& of, Real room) {
    if (are_of_one_sphere(ring, of, room)) return true;
    const auto all_rims = [&](const auto& holds) { return std::ranges::all_of(ring.rims, holds); };
    if (of.disc() != nullptr)
        return all_rims([&](const Rim& rim) { return of.rims[1].sense * (rim.height - of.middle) >= -room; });
    if (of.zone() == nullptr) {
        if (ring.zone() != nullptr) return excess(ring, of) <= room;
        return all_rims([&](const Rim& rim) { return rim.radius <= of.radius_at(rim.height) + room; });
    }
    // Tangent planes touch the zone in all directions between those of its rims. The one that leaves least room for a
    // rim does so in the rim's direction, or at an end; for a zone, at an end of the directions that both have.
    const auto direction = [](const Rim& rim, Real middle) { return std::atan2(rim.height - middle, rim.radius); };
    const Real low = direction(of.rims[0], of.middle);
    const Real high = direction(of.rims[1], of.middle);
    const Real most = of.zone()->radius + room;
    if (ring.zone() != nullptr) {
        const Real begin = std::max(low, direction(ring.rims[0], ring.middle));
        const Real end = std::min(high, direction(ring.rims[1], ring.middle));
        for (const Real at : {begin, end}) {
            if (begin <= end && (ring.middle - of.middle) * std::sin(at) + ring.zone()->radius > most) return false;
        }
    }
    return all_rims([&](const Rim& rim) {
        const Real nearest = std::clamp(direction(rim, of.middle), low, high);
        return (rim.height - of.middle) * std::sin(nearest) + rim.radius * std::cos(nearest) <= most;
    });
}

/// Whether a surface is shown to meet no line from one ring to another.
bool keeps_clear(const Surface& surface, const Turned& from, const Turned& to, const Axis& axis) {
    const Real room = axis.room();
    const std::array rims{from.rims[0], from.rims[1], to.rims[0], to.rims[1]};
    const auto [lowest, highest] = std::ranges::minmax(rims, {}, &Rim::height);
    const Extent heights = extent(surface, axis.direction);
    const Real start = axis.direction.dot(axis.origin);
    if (heights.low - start >= highest.height - room || heights.high - start <= lowest.height + room) return true;
    // What is in front of all places of a surface is convex, and holds the lines between two rings that it holds.
    const auto around = turned(surface, axis);
    return around && is_in_front(from, *around, room) && is_in_front(to, *around, room);
}

/// Exchange area of the discs that two rims bound.
Real between_discs(const Rim& a, const Rim& b, Real room) {
    const Real smaller = std::min(a.radius, b.radius);
    if (smaller <= room) return 0;
    const Real distance = std::abs(a.height - b.height);
    if (distance <= room) return std::numbers::pi_v<Real> * smaller * smaller;
    return std::numbers::pi_v<Real> * a.radius * a.radius * coaxial_discs_factor(a.radius, b.radius, distance);
}

}  // namespace

std::optional<BoundedValue<double>> coaxial_exchange_area(const Surface& from, const Surface& to,
                                                          std::span<const Blocker> between) {
    auto axis = axis_of(from);
    if (!axis || !radiates_inwards(from) || !radiates_inwards(to)) return std::nullopt;
    Eigen::AlignedBox3d box = box_around(from);
    box.extend(box_around(to));
    axis->extent = box.diagonal().norm() + axis->origin.norm();
    const auto a = turned(from, *axis);
    const auto b = turned(to, *axis);
    if (!a || !b || !is_in_front(*a, *b, axis->room()) || !is_in_front(*b, *a, axis->room())) return std::nullopt;
    const auto is_clear_of = [&](const Blocker& blocker) { return keeps_clear(*blocker.surface, *a, *b, *axis); };
    if (!std::ranges::all_of(between, is_clear_of)) return std::nullopt;
    Real sum = &from == &to ? area(from.shape) : 0;
    for (const Rim& rim : a->rims) {
        for (const Rim& other : b->rims) sum -= rim.sense * other.sense * between_discs(rim, other, axis->room());
    }
    return BoundedValue<double>{std::max(0.0, static_cast<double>(sum)),
                                error_by_tolerance * axis->extent * axis->extent};
}

}  // namespace ff

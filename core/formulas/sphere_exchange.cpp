#include "core/formulas/sphere_exchange.hpp"

#include "core/formulas/circle_rule.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using circles::Circle;
using circles::Frame;
using circles::PeriodicRule;
using Eigen::Vector3d;

constexpr double rounding_unit = std::numeric_limits<double>::epsilon();

/// A surface as seen from a place, the eye.
struct Sight {
    double room = 0;            ///< distance of the eye from the nearest tangent plane; negative behind it
    Vector3d axis;              ///< of round surfaces
    std::vector<Circle> rims;   ///< what lies beyond each along the axis counts with its sign
    BoundedValue<double> seen;  ///< solid angle of polygons
};

/// Solid angle of a triangle whose corners are given relative to the eye. @see [vanoosterom1983]
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double across =
        a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
    return 2 * std::atan2(std::abs(a.dot(b.cross(c))), across);
}

Sight sight_of_polygon(const Surface& surface, const Vector3d& eye, const Frame& frame) {
    std::vector<Vector3d> around;
    for (const Vector3d& corner : corners(surface.shape)) around.push_back(frame.moved(corner) - eye);
    Sight sight{-surface.normal.dot(around.front()), {}, {}, {}};
    for (std::size_t k = 2; k < around.size(); ++k)
        sight.seen.value += solid_angle(around[0], around[k - 1], around[k]);
    sight.seen.error = 32 * rounding_unit * (1 + sight.seen.value);
    return sight;
}

Sight sight_of_disc(const Surface& surface, const Disc& disc, const Vector3d& eye, const Frame& frame) {
    const Vector3d centre = frame.moved(disc.centre);
    const Vector3d axis = -surface.normal;
    Sight sight{axis.dot(centre - eye), axis, {}, {}};
    sight.rims.emplace_back(centre, axis, disc.outer_radius / frame.unit, 1);
    sight.rims.emplace_back(centre, axis, disc.inner_radius / frame.unit, -1);
    return sight;
}

Sight sight_of_wall(const Frustum& wall, const Vector3d& eye, const Frame& frame) {
    const Vector3d base = frame.moved(wall.base);
    Sight sight{0, wall.axis.normalized(), {}, {}};
    sight.rims.emplace_back(base, sight.axis, wall.base_radius / frame.unit, 1);
    sight.rims.emplace_back(frame.moved(wall.base + wall.axis), sight.axis, wall.top_radius / frame.unit, -1);
    const double height = sight.axis.dot(eye - base);
    const double off_axis = (eye - base - height * sight.axis).norm();
    const double slope = (wall.top_radius - wall.base_radius) / wall.axis.norm();
    sight.room = (sight.rims[0].radius + slope * height - off_axis) / std::hypot(1, slope);
    return sight;
}

Sight sight_of_zone(const SphereZone& zone, const Vector3d& eye, const Frame& frame) {
    const Vector3d centre = frame.moved(zone.centre);
    const double radius = zone.radius / frame.unit;
    Sight sight{0, zone.axis, {}, {}};
    for (const auto& [share, sign] : {std::pair(zone.low, 1.0), std::pair(zone.high, -1.0)})
        sight.rims.emplace_back(centre + share * radius * zone.axis, zone.axis,
                                radius * std::sqrt((1 - share) * (1 + share)), sign);
    // The nearest tangent plane touches the zone in the direction of the eye, or at a rim.
    const double height = zone.axis.dot(eye - centre);
    const double off_axis = (eye - centre - height * zone.axis).norm();
    const double nearest = std::clamp(std::atan2(height, off_axis), std::asin(zone.low), std::asin(zone.high));
    sight.room = radius - height * std::sin(nearest) - off_axis * std::cos(nearest);
    return sight;
}

std::optional<Sight> sight_of(const Surface& surface, const Vector3d& eye, const Frame& frame) {
    if (is_polygon(surface.shape)) return sight_of_polygon(surface, eye, frame);
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) return sight_of_disc(surface, *disc, eye, frame);
    if (facing(surface.shape) != Facing::inward) return std::nullopt;
    if (const auto* wall = std::get_if<Frustum>(&surface.shape)) return sight_of_wall(*wall, eye, frame);
    return sight_of_zone(std::get<SphereZone>(surface.shape), eye, frame);
}

/// Solid angle of what lies beyond a rim along an axis.
std::optional<BoundedValue<double>> beyond(const Circle& rim, const Vector3d& axis, const Vector3d& eye,
                                           double wanted) {
    const double above = axis.dot(rim.centre - eye);
    const double whole = above < 0 ? 4 * std::numbers::pi : 0;
    if (rim.radius == 0) return BoundedValue<double>{whole, 4 * rounding_unit * whole};
    const double height = std::abs(above);
    const Vector3d foot = eye + above * axis;
    const double nearest = rim.distance_to(eye);
    // In half of the strip |r| >= nearest / 2 and, since r^2 has a positive real part, |r + height| >= that / sqrt(2).
    const double most =
        (Frame::farthest + nearest / 2) * (rim.radius + nearest / 2) * 4 * std::numbers::sqrt2 / (nearest * nearest);
    const PeriodicRule rule(rim.half_strip(nearest), most, wanted / (2 * std::numbers::pi));
    if (rule.has_too_many_nodes()) return std::nullopt;
    double sum = 0;
    double sizes = 0;
    for (std::size_t k = 0; k < rule.nodes; ++k) {
        const double theta = rule.angle(k);
        const Vector3d way = rim.at(theta) - foot;
        const double r = std::hypot(way.norm(), height);
        const double term = axis.dot(way.cross(rim.along(theta))) / (r * (r + height));
        sum += term;
        sizes += std::abs(term);
    }
    const double weight = 2 * std::numbers::pi / static_cast<double>(rule.nodes);
    const double error = 2 * std::numbers::pi * rule.error + 16 * rounding_unit * (weight * sizes + whole);
    return BoundedValue<double>{above < 0 ? whole - weight * sum : weight * sum, error};
}

const SphereZone* whole_sphere(const Surface& surface) {
    const auto* zone = std::get_if<SphereZone>(&surface.shape);
    const bool is_whole = zone != nullptr && zone->low == -1 && zone->high == 1 && zone->facing == Facing::outward;
    return is_whole ? zone : nullptr;
}

}  // namespace

std::optional<BoundedValue<double>> sphere_exchange_area(const Surface& from, const Surface& to, double wanted) {
    const SphereZone* const sphere = whole_sphere(from);
    if (sphere == nullptr) return whole_sphere(to) != nullptr ? sphere_exchange_area(to, from, wanted) : std::nullopt;
    const Frame frame(from, to);
    const Vector3d eye = frame.moved(sphere->centre);
    const double square = frame.reduced(sphere->radius * sphere->radius);
    const auto sight = sight_of(to, eye, frame);
    if (!sight || sight->room < std::sqrt(square) - Frame::rounding) return std::nullopt;
    BoundedValue<double> seen = sight->seen;
    for (const Circle& rim : sight->rims) {
        const auto angle = beyond(rim, sight->axis, eye, frame.reduced(wanted) / (4 * square));
        if (!angle) return std::nullopt;
        seen.value += rim.sign * angle->value;
        seen.error += angle->error;
    }
    return frame.restored(BoundedValue<double>{square * seen.value, square * seen.error});
}

}  // namespace ff

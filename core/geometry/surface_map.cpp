#include "core/geometry/surface_map.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/unit_circle.hpp"
#include "core/support/overloaded.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

using Eigen::Vector3d;

/// How far along the wall of a frustum, 0 to 1, a share s of its area lies: s (r0 + r1) = x (2 r0 + x (r1 - r0)).
double along_wall(const Frustum& wall, double s) {
    const double r0 = wall.base_radius;
    const double r1 = wall.top_radius;
    if (s <= 0) return 0;
    return s * (r0 + r1) / (r0 + std::sqrt(r0 * r0 + s * (r1 - r0) * (r1 + r0)));
}

/// Azimuth in turns, in [0, 1).
double azimuth(double x, double y) {
    const double turns = std::atan2(y, x) / (2 * std::numbers::pi);
    return turns < 0 ? turns + 1 : turns;
}

double sign(Facing facing) {
    return facing == Facing::outward ? 1 : -1;
}

SurfaceCoordinates clamped(double s, double t) {
    return {std::clamp(s, 0.0, 1.0), std::clamp(t, 0.0, 1.0)};
}

/// Coordinates of `offset` in the basis of two vectors of its plane.
SurfaceCoordinates in_basis(const Vector3d& offset, const Vector3d& u, const Vector3d& v) {
    const Vector3d normal = u.cross(v);
    const double squared = normal.squaredNorm();
    return {offset.dot(v.cross(normal)) / squared, offset.dot(normal.cross(u)) / squared};
}

/// The extent of a circle along a direction.
Extent of_ring(const Vector3d& direction, const Vector3d& centre, const Vector3d& axis, double radius) {
    const double reach = radius * (direction - direction.dot(axis) * axis).norm();
    const double middle = direction.dot(centre);
    return {middle - reach, middle + reach};
}

/// The greatest product of `direction` with the points of the zone of a unit sphere: concave in the height.
double reach_of_zone(const SphereZone& zone, const Vector3d& direction) {
    const double length = direction.norm();
    if (length == 0) return 0;
    const double upwards = direction.dot(zone.axis);
    const double height = std::clamp(upwards / length, zone.low, zone.high);
    const double sideways = (direction - upwards * zone.axis).norm();
    return height * upwards + std::sqrt(std::max(0.0, (1 - height) * (1 + height))) * sideways;
}

std::array<Vector3d, 4> corners_of(const Parallelogram& p) {
    return {p.corner, p.corner + p.edge_u, p.corner + p.edge_u + p.edge_v, p.corner + p.edge_v};
}

}  // namespace

Vector3d perpendicular(const Vector3d& axis) {
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    const Vector3d direction = axis.normalized();
    return (Vector3d::Unit(least) - direction[least] * direction).normalized();
}

SurfaceMap::SurfaceMap(const Surface& surface) : shape_(surface.shape), normal_(surface.normal), z_(surface.normal) {
    if (const auto* wall = std::get_if<Frustum>(&shape_)) z_ = wall->axis.normalized();
    if (const auto* zone = std::get_if<SphereZone>(&shape_)) z_ = zone->axis;
    if (const auto* p = std::get_if<Parallelogram>(&shape_)) {
        x_ = p->edge_u.normalized();
    } else if (const auto* triangle = std::get_if<Triangle>(&shape_)) {
        x_ = (triangle->c - triangle->b).normalized();
    } else {
        x_ = perpendicular(z_);
    }
    y_ = z_.cross(x_);
}

SurfacePoint SurfaceMap::at(double s, double t) const {
    if (const auto* p = std::get_if<Parallelogram>(&shape_)) {
        return {p->corner + s * p->edge_u + t * p->edge_v, normal_, x_};
    }
    if (const auto* p = std::get_if<Triangle>(&shape_)) {
        return {p->a + std::sqrt(s) * ((1 - t) * (p->b - p->a) + t * (p->c - p->a)), normal_, x_};
    }
    const auto [cosine, sine] = unit_circle(t);
    const Vector3d outwards = cosine * x_ + sine * y_;
    const Vector3d around = cosine * y_ - sine * x_;
    if (const auto* p = std::get_if<Disc>(&shape_)) {
        const double inner = p->inner_radius * p->inner_radius;
        const double radius = std::sqrt(inner + s * (p->outer_radius * p->outer_radius - inner));
        return {p->centre + radius * outwards, normal_, around};
    }
    if (const auto* p = std::get_if<Frustum>(&shape_)) {
        const double x = along_wall(*p, s);
        const double growth = p->top_radius - p->base_radius;
        const Vector3d normal = (p->axis.norm() * outwards - growth * z_).normalized();
        return {p->base + x * p->axis + (p->base_radius + x * growth) * outwards, sign(p->facing) * normal, around};
    }
    const auto& p = std::get<SphereZone>(shape_);
    const double height = p.low + s * (p.high - p.low);
    const double radius = std::sqrt(std::max(0.0, (1 - height) * (1 + height)));
    const Vector3d normal = radius * outwards + height * z_;
    return {p.centre + p.radius * normal, sign(p.facing) * normal, around};
}

SurfaceCoordinates SurfaceMap::coordinates(const Vector3d& place) const {
    return std::visit(
        Overloaded{
            [&](const Parallelogram& p) {
                const auto [s, t] = in_basis(place - p.corner, p.edge_u, p.edge_v);
                return clamped(s, t);
            },
            [&](const Triangle& p) {
                const auto [towards_b, towards_c] = in_basis(place - p.a, p.b - p.a, p.c - p.a);
                const double depth = towards_b + towards_c;
                return clamped(depth * depth, depth > 0 ? towards_c / depth : 0);
            },
            [&](const Disc& p) {
                const Vector3d offset = place - p.centre;
                const double inner = p.inner_radius * p.inner_radius;
                const double share = (offset.squaredNorm() - inner) / (p.outer_radius * p.outer_radius - inner);
                return clamped(share, azimuth(offset.dot(x_), offset.dot(y_)));
            },
            [&](const Frustum& p) {
                const Vector3d offset = place - p.base;
                const double x = std::clamp(offset.dot(z_) / p.axis.norm(), 0.0, 1.0);
                const double r0 = p.base_radius;
                const double r1 = p.top_radius;
                return clamped(x * (2 * r0 + x * (r1 - r0)) / (r0 + r1), azimuth(offset.dot(x_), offset.dot(y_)));
            },
            [&](const SphereZone& p) {
                const Vector3d offset = place - p.centre;
                const double height = offset.dot(z_) / p.radius;
                return clamped((height - p.low) / (p.high - p.low), azimuth(offset.dot(x_), offset.dot(y_)));
            },
        },
        shape_);
}

Vector3d normal_at(const Surface& surface, const Vector3d& place) {
    if (is_flat(surface.shape)) return surface.normal;
    const SurfaceMap map(surface);
    const auto [s, t] = map.coordinates(place);
    return map.at(s, t).normal;
}

Extent extent(std::span<const Vector3d> points, const Vector3d& direction) {
    Extent all{direction.dot(points.front()), direction.dot(points.front())};
    for (const Vector3d& point : points) {
        all.low = std::min(all.low, direction.dot(point));
        all.high = std::max(all.high, direction.dot(point));
    }
    return all;
}

Extent extent(const Surface& surface, const Vector3d& direction) {
    return std::visit(Overloaded{
                          [&](const Parallelogram& p) { return extent(corners_of(p), direction); },
                          [&](const Triangle& p) {
                              return extent(std::array{p.a, p.b, p.c}, direction);
                          },
                          [&](const Disc& p) { return of_ring(direction, p.centre, surface.normal, p.outer_radius); },
                          [&](const Frustum& p) {
                              const Vector3d axis = p.axis.normalized();
                              const Extent base = of_ring(direction, p.base, axis, p.base_radius);
                              const Extent top = of_ring(direction, p.base + p.axis, axis, p.top_radius);
                              return Extent{std::min(base.low, top.low), std::max(base.high, top.high)};
                          },
                          [&](const SphereZone& p) {
                              const double middle = direction.dot(p.centre);
                              return Extent{middle - p.radius * reach_of_zone(p, -direction),
                                            middle + p.radius * reach_of_zone(p, direction)};
                          },
                      },
                      surface.shape);
}

Eigen::AlignedBox3d box_around(const Surface& surface) {
    if (const auto* p = std::get_if<Parallelogram>(&surface.shape)) return box_around(corners_of(*p));
    if (const auto* p = std::get_if<Triangle>(&surface.shape)) return box_around(std::array{p->a, p->b, p->c});
    Eigen::AlignedBox3d box;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(surface, Vector3d::Unit(axis));
        box.min()[axis] = along.low;
        box.max()[axis] = along.high;
    }
    return box;
}

Eigen::AlignedBox3d box_around(const Scene& scene) {
    Eigen::AlignedBox3d box;
    for (const Surface& surface : scene.surfaces) box.extend(box_around(surface));
    return box;
}

std::vector<Eigen::AlignedBox3d> boxes_around(std::span<const Surface> surfaces) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces) boxes.push_back(box_around(surface));
    return boxes;
}

Vector3d middle(const Surface& surface) {
    const Eigen::AlignedBox3d box = box_around(surface);
    return (box.min() + box.max()) / 2;
}

}  // namespace ff

#include "core/geometry/line_meets.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/overloaded.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;
constexpr double never = std::numeric_limits<double>::infinity();

/// a time^2 + 2 b time + c = 0: where a line meets the whole quadric that a curved surface is part of.
struct Quadratic {
    double a = 0, b = 0, c = 0;
};

using Meetings = std::array<Meeting, 2>;
constexpr Meetings none{Meeting{never}, Meeting{never}};

/// Both roots, the smaller first; `never` for missing ones. No difference of nearly equal numbers is taken.
Meetings roots(const Quadratic& q) {
    const double discriminant = q.b * q.b - q.a * q.c;
    if (!(discriminant >= 0)) return none;
    const double sum = -(q.b + std::copysign(std::sqrt(discriminant), q.b));
    // The slope at a root, a time + b, is the square root of the discriminant with one sign or the other.
    const bool falling = std::signbit(q.b);
    Meetings both{Meeting{q.a == 0 ? never : sum / q.a, falling}, Meeting{sum == 0 ? never : q.c / sum, !falling}};
    if (both[1].time < both[0].time) std::swap(both[0], both[1]);
    return both;
}

/// The meetings that count, given that some ends of the line are roots.
Meetings other_roots(const Quadratic& q, Ends ends, Facing facing) {
    if (!ends.begins && !ends.ends) return roots(q);
    // A surface that bulges towards the other end is not met again.
    if ((ends.begins && ends.ends) || facing == Facing::outward || q.a == 0) return none;
    if (ends.ends) return {Meeting{-2 * q.b / q.a - 1, q.a < 0}, Meeting{never}};
    // The line leads inwards: b > 0 is rounding, and then it meets the surface where it starts.
    return {Meeting{q.a > 0 ? -2 * std::min(q.b, 0.0) / q.a : never, true}, Meeting{never}};
}

template <class Inside>
std::optional<Meeting> first_inside(const Meetings& meetings, Inside inside) {
    for (const Meeting& meeting : meetings) {
        if (meeting.time >= 0 && meeting.time < never && inside(meeting.time)) return meeting;
    }
    return std::nullopt;
}

/// When a line meets a plane.
Meetings plane_time(const Line& line, const Vector3d& place, const Vector3d& normal) {
    const double speed = normal.dot(line.direction);
    return {Meeting{speed == 0 ? never : normal.dot(place - line.origin) / speed}, Meeting{never}};
}

/// Whether a place of its plane lies on a parallelogram (`sum_below` 2) or triangle (1) that two edges span.
bool spans(const Vector3d& offset, const Vector3d& u, const Vector3d& v, double sum_below) {
    const Vector3d normal = u.cross(v);
    const double size = normal.squaredNorm();
    const double along_u = offset.cross(v).dot(normal);
    const double along_v = u.cross(offset).dot(normal);
    return along_u >= 0 && along_v >= 0 && along_u <= size && along_v <= size && along_u + along_v <= sum_below * size;
}

}  // namespace

std::optional<Meeting> line_meets(const Line& line, const Surface& surface, Ends ends, double rim) {
    const Vector3d& origin = line.origin;
    const Vector3d& direction = line.direction;
    if (is_flat(surface.shape) && (ends.begins || ends.ends)) return std::nullopt;
    return std::visit(
        Overloaded{
            [&](const Parallelogram& p) {
                return first_inside(plane_time(line, p.corner, surface.normal), [&](double time) {
                    return spans(line.at(time) - p.corner, p.edge_u, p.edge_v, 2);
                });
            },
            [&](const Triangle& p) {
                return first_inside(plane_time(line, p.a, surface.normal),
                                    [&](double time) { return spans(line.at(time) - p.a, p.b - p.a, p.c - p.a, 1); });
            },
            [&](const Disc& p) {
                const double room = rim * p.outer_radius;
                return first_inside(plane_time(line, p.centre, surface.normal), [&](double time) {
                    const double radius = (line.at(time) - p.centre).norm();
                    return radius >= p.inner_radius - room && radius <= p.outer_radius + room;
                });
            },
            [&](const Frustum& p) {
                const double height = p.axis.norm();
                const Vector3d axis = p.axis / height;
                const Vector3d offset = origin - p.base;
                const double start = offset.dot(axis);
                const double speed = direction.dot(axis);
                const Vector3d sideways = offset - start * axis;
                const Vector3d sideways_speed = direction - speed * axis;
                const double slope = (p.top_radius - p.base_radius) / height;
                const double radius = p.base_radius + slope * start;
                const Quadratic q{sideways_speed.squaredNorm() - slope * slope * speed * speed,
                                  sideways.dot(sideways_speed) - slope * radius * speed,
                                  sideways.squaredNorm() - radius * radius};
                const double room = rim * (height + p.base_radius + p.top_radius);
                return first_inside(other_roots(q, ends, p.facing), [&](double time) {
                    const double place = start + time * speed;
                    return place >= -room && place <= height + room;
                });
            },
            [&](const SphereZone& p) {
                const Vector3d offset = origin - p.centre;
                const Quadratic q{direction.squaredNorm(), offset.dot(direction),
                                  offset.squaredNorm() - p.radius * p.radius};
                return first_inside(other_roots(q, ends, p.facing), [&](double time) {
                    const double height = (offset + time * direction).dot(p.axis) / p.radius;
                    return (p.low <= -1 || height >= p.low - rim) && (p.high >= 1 || height <= p.high + rim);
                });
            },
        },
        surface.shape);
}

}  // namespace ff

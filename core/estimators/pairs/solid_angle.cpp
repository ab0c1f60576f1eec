#include "core/estimators/pairs/solid_angle.hpp"

#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/geometry/unit_circle.hpp"
#include "core/visibility/occlusion.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace ff {
namespace {

/// A point with one coordinate along a line, and another one across it.
struct Reach {
    double along = 0;
    double length = 0;  ///< distance of the point
};

Reach reach(double along, double across) {
    return {along, std::sqrt(along * along + across * across)};
}

/// b.along a.length - a.along b.length, of two points at the same distance across. Does not cancel where they are near
/// each other. @param apart  b.along - a.along
double between(const Reach& a, const Reach& b, double apart, double across) {
    const double sum = b.along * a.length + a.along * b.length;
    if (a.along * b.along <= 0) return b.along * a.length - a.along * b.length;
    return apart * (a.along + b.along) * across * across / sum;
}

/// The square root of a value that can be 0 or negative only through rounding. The result is positive, but then so
/// small that a length divided by it is clamped to the rim.
double root_above_zero(double value) {
    return std::sqrt(std::max(value, std::numeric_limits<double>::min()));
}

using Eigen::Vector3d;

/// The direction, at a point of the unit sphere, of the arc to another one. @pre they differ
Vector3d arc_direction(const Vector3d& from, const Vector3d& to) {
    const Vector3d chord = to - from;
    return (chord + 0.5 * chord.squaredNorm() * from).normalized();
}

/// The point of the arc that begins at `from` at an angle with this versed sine, 1 - cos.
Vector3d along_arc(const Vector3d& from, const Vector3d& direction, double versed) {
    return (1 - versed) * from + std::sqrt(versed * (2 - versed)) * direction;
}

/// A patch that is looked at from places of another.
struct TargetPatch {
    std::array<Vector3d, 4> corners;
    Vector3d normal;
    std::array<double, 2> twice_area;  ///< those of the triangles of corners 0, 1, 2 and 0, 2, 3
    double width;
    double height;
    bool is_rectangle;

    explicit TargetPatch(const PatchView& patch) : corners(patch.corners()), normal(patch.surface->normal) {
        for (std::size_t k = 0; k < 2; ++k)
            twice_area[k] = (corners[k + 1] - corners[0]).cross(corners[k + 2] - corners[0]).norm();
        const Vector3d u = corners[1] - corners[0];
        const Vector3d v = corners[3] - corners[0];
        width = u.norm();
        height = v.norm();
        is_rectangle =
            std::holds_alternative<Parallelogram>(patch.surface->shape) && std::abs(u.dot(v)) <= 1e-14 * width * height;
    }
};

/// A direction in a target, and half the solid angle that it was drawn from.
struct Look {
    Vector3d direction = Vector3d::Zero();
    double half_area = 0;
};

Look look_at_rectangle(const TargetPatch& target, const Vector3d& place, double distance, double s, double t) {
    const Vector3d u = (target.corners[1] - target.corners[0]) / target.width;
    const Vector3d v = (target.corners[3] - target.corners[0]) / target.height;
    const Vector3d corner = target.corners[0] - place;
    const SeenRectangle seen{corner.dot(u), corner.dot(v), target.width, target.height, distance};
    const double half_area = half_solid_angle(seen);
    const Eigen::Vector2d end = place_in(seen, half_area, s, t);
    return {(corner + end.x() * u + end.y() * v).normalized(), half_area};
}

/// Looks at the target as two triangles: the first coordinate selects one, and a place in it.
Look look_at_triangles(const TargetPatch& target, const Vector3d& place, double distance, double s, double t) {
    std::array<Vector3d, 4> to;
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = target.corners[k] - place;
    const std::array triangles{spherical_triangle(to[1], to[0], to[2], distance * target.twice_area[0]),
                               spherical_triangle(to[2], to[0], to[3], distance * target.twice_area[1])};
    const double half_area = triangles[0].half_area + triangles[1].half_area;
    const double at = s * half_area;
    const std::size_t chosen = at < triangles[0].half_area ? 0 : 1;
    const SphericalTriangle& triangle = triangles[chosen];
    if (!(triangle.half_area > 0)) return {};
    const double within = (chosen == 0 ? at : at - triangles[0].half_area) / triangle.half_area;
    return {direction_in(triangle, within, t), half_area};
}

/// Solid angle times cosine over pi in one direction from a place; 0 where something hides the target.
double value_at(const PatchPair& pair, const TargetPatch& target, const SurfacePoint& place, double s, double t) {
    const double distance = (place.position - target.corners[0]).dot(target.normal);
    if (!(distance > 0)) return 0;
    const auto look = target.is_rectangle ? look_at_rectangle : look_at_triangles;
    const auto [direction, half_area] = look(target, place.position, distance, s, t);
    const double cosine = direction.dot(place.normal);
    if (!(cosine > 0)) return 0;
    if (!pair.blockers->empty()) {
        const double approach = -direction.dot(target.normal);
        if (!(approach > 0)) return 0;
        const Vector3d end = place.position + distance / approach * direction;
        if (!sees(place.position, *pair.from.surface, end, *pair.to.surface, *pair.blockers)) return 0;
    }
    return 2 * half_area * cosine / std::numbers::pi;
}

}  // namespace

double half_solid_angle(const SeenRectangle& seen) {
    const double x = seen.x + seen.width;
    const double y = seen.y + seen.height;
    const Eigen::Vector3d near{seen.x, seen.y, seen.distance};
    const Eigen::Vector3d right{x, seen.y, seen.distance};
    const Eigen::Vector3d far{x, y, seen.distance};
    const Eigen::Vector3d left{seen.x, y, seen.distance};
    const double diagonal = near.dot(far);
    const double n = near.norm();
    const double f = far.norm();
    const auto cosine = [&](const Eigen::Vector3d& corner) {
        const double length = corner.norm();
        return n * f * length + diagonal * length + near.dot(corner) * f + far.dot(corner) * n;
    };
    // A diagonal divides the rectangle into two triangles. Half their solid angles are arguments of complex numbers,
    // which add when the numbers are multiplied.
    const double volume = seen.width * seen.height * seen.distance;
    const double a = cosine(right);
    const double b = cosine(left);
    return angle_of(std::max(volume * (a + b), 0.0), a * b - volume * volume);
}

Eigen::Vector2d place_in(const SeenRectangle& seen, double half_area, double s, double t) {
    const double z = seen.distance;
    const Reach low = reach(seen.y, z);
    const Reach high = reach(seen.y + seen.height, z);
    // The solid angle left of the line at x, up to a constant, is tau = asin(sigma eta_1) - asin(sigma eta_0), with
    // sigma = x / |(x, z)| and eta = y / |(y, z)|: here at the left side.
    const double side = std::sqrt(seen.x * seen.x + z * z);
    const Reach low_left = reach(seen.y, side);
    const Reach high_left = reach(seen.y + seen.height, side);
    const double lengths = low.length * high.length;
    const double scale = 1 / (side * side * lengths);
    const double sine_left = seen.x * z * between(low_left, high_left, seen.height, side) * scale;
    const double cosine_left =
        (z * z * low_left.length * high_left.length + seen.x * seen.x * low.along * high.along) * scale;
    // At the line that is looked for, and solved for sigma there: sin tau over the third side of a triangle with sides
    // eta_0 and eta_1 and the angle tau between them.
    const CirclePoint part = unit_circle(s * half_area / std::numbers::pi);
    const double sine = sine_left * part.cosine + cosine_left * part.sine;
    const double cosine = cosine_left * part.cosine - sine_left * part.sine;
    const double versed = cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine;
    const double apart = between(low, high, seen.height, z) / lengths;
    const double third = apart * apart + 2 * low.along * high.along / lengths * versed;
    const double x = z * sine / root_above_zero(third - sine * sine);
    const double from_left = std::clamp(x - seen.x, 0.0, seen.width);
    // Along the line, shares are those of y / |(y, d)|, d its distance.
    const double placed = seen.x + from_left;
    const double d = std::sqrt(placed * placed + z * z);
    const Reach begin = reach(seen.y, d);
    const Reach end = reach(seen.y + seen.height, d);
    const double eta =
        begin.along / begin.length + t * between(begin, end, seen.height, d) / (begin.length * end.length);
    const double y = d * eta / root_above_zero(1 - eta * eta);
    return {from_left, std::clamp(y - seen.y, 0.0, seen.height)};
}

SphericalTriangle spherical_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, double volume) {
    const double u = a.norm();
    const double v = b.norm();
    const double w = c.norm();
    // The tangent of half the solid angle. @see [vanoosterom1983]
    const double half_area = angle_of(volume, u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
    return {a / u, b / v, c / w, half_area};
}

Vector3d direction_in(const SphericalTriangle& triangle, double s, double t) {
    const auto& [a, b, c, half_area] = triangle;
    const Vector3d to_b = arc_direction(a, b);
    const Vector3d to_c = arc_direction(a, c);
    const double cosine = to_b.dot(to_c);
    const double sine = to_b.cross(to_c).norm();
    // The end on the arc from a to c of the part with the share s of the area: the tangent of half its angle at the
    // centre, from the tangent of half the area of a triangle with two sides and the angle between them.
    const CirclePoint part = unit_circle(s * half_area / (2 * std::numbers::pi));
    const double half_tangent_ab = (b - a).norm() / (b + a).norm();
    const double tangent = part.sine / (half_tangent_ab * (sine * part.cosine - cosine * part.sine));
    const double squared = tangent * tangent;
    const Vector3d end = along_arc(a, to_c, 2 * squared / (1 + squared));
    // Towards it from b, by heights of equal zones.
    const Vector3d chord = end - b;
    const double versed = 0.5 * chord.squaredNorm();
    if (!(versed > 0)) return b;
    return along_arc(b, arc_direction(b, end), t * versed);
}

void SolidAngle::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates =
        average_over_pairs(scene(), task, info.dimension, [](const PatchPair& pair, const WeightedBlock& block) {
            const TargetPatch target(pair.to);
            double sum = 0;
            for (std::size_t i = 0; i < block.size; ++i) {
                const SurfacePoint place = pair.from.at(block.coordinate[0][i], block.coordinate[1][i]);
                sum += block.weight[i] * value_at(pair, target, place, block.coordinate[2][i], block.coordinate[3][i]);
            }
            return sum;
        });
}

}  // namespace ff

#include "core/estimators/pairs/spherical_rectangle.hpp"

#include "core/geometry/unit_circle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ff {
namespace {

/// A point with one coordinate along a line, and another one across it.
struct Reach {
    double along = 0;
    double length = 0;  ///< to it
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

}  // namespace ff

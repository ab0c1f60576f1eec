#include "core/formulas/polygon_exchange.hpp"

#include "core/support/contract.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace ff {
namespace {

/// Twice the area along the normal of the side that radiates.
template <class Real>
Vector3<Real> doubled_area(const Corners<Real>& polygon) {
    Vector3<Real> sum = Vector3<Real>::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum;
}

/// A plane through a point; normal of unit length.
template <class Real>
struct Plane {
    Vector3<Real> point;
    Vector3<Real> normal;

    /// Heights within rounding of the plane count as none, so that what touches it stays as it is.
    [[nodiscard]] Real height(const Vector3<Real>& x) const {
        const Vector3<Real> from_point = x - point;
        const Real distance = from_point.dot(normal);
        return std::abs(distance) <= 8 * std::numeric_limits<Real>::epsilon() ? Real{0} : distance;
    }
};

template <class Real>
Plane<Real> plane_of(const Corners<Real>& polygon) {
    return {polygon[0], doubled_area(polygon).normalized()};
}

/// The part in front of a plane. A polygon with bays may come out with edges along the plane there and back; they
/// cancel in a contour integral.
template <class Real>
Corners<Real> in_front(const Plane<Real>& plane, const Corners<Real>& polygon) {
    Corners<Real> front;
    if (std::none_of(polygon.begin(), polygon.end(), [&](const auto& x) { return plane.height(x) > 0; })) return front;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3<Real>& a = polygon[i];
        const Vector3<Real>& b = polygon[(i + 1) % polygon.size()];
        const Real height_a = plane.height(a);
        const Real height_b = plane.height(b);
        if (height_a >= 0) front.push_back(a);
        if (height_a * height_b < 0) front.push_back(a + height_a / (height_a - height_b) * (b - a));
    }
    return front;
}

/// Corners relative to `origin`, divided by `unit`.
template <class Real>
void shrink(Corners<Real>& polygon, const Vector3<Real>& origin, Real unit) {
    for (Vector3<Real>& corner : polygon) corner = (corner - origin) / unit;
}

}  // namespace

template <class Real>
Corners<Real> corners_of(const Surface& surface) {
    Corners<Real> result;
    for (const Eigen::Vector3d& corner : corners(surface.shape)) result.push_back(corner.template cast<Real>());
    const Vector3<Real> across = (result[1] - result[0]).cross(result[2] - result[1]);
    if (across.dot(surface.normal.template cast<Real>()) < 0) std::reverse(result.begin(), result.end());
    return result;
}

template <class Real>
BoundedValue<Real> polygon_exchange_area(Corners<Real> from, Corners<Real> to) {
    FF_EXPECT(from.size() >= 3 && to.size() >= 3);
    const Vector3<Real> origin = from[0];
    Real extent = 0;
    for (const auto* polygon : {&from, &to}) {
        for (const Vector3<Real>& corner : *polygon) extent = std::max(extent, (corner - origin).norm());
    }
    const Real unit = std::scalbn(Real{1}, std::ilogb(extent));  // a power of two: dividing by it is exact
    shrink(from, origin, unit);
    shrink(to, origin, unit);

    const Plane<Real> from_plane = plane_of(from);
    const Plane<Real> to_plane = plane_of(to);
    from = in_front(to_plane, from);
    to = in_front(from_plane, to);
    if (from.size() < 3 || to.size() < 3) return {};

    BoundedValue<Real> sum;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const DirectedEdge<Real> edge{from[i], from[(i + 1) % from.size()]};
        for (std::size_t j = 0; j < to.size(); ++j) {
            const auto term = log_distance_integral<Real>(edge, {to[j], to[(j + 1) % to.size()]});
            sum.value += term.value;
            sum.error += term.error;
        }
    }
    const Real scale = unit * unit / (2 * std::numbers::pi_v<Real>);
    return {std::max(Real{0}, sum.value) * scale, sum.error * scale};
}

template <class Real>
Real polygon_area(const Corners<Real>& polygon) {
    return doubled_area(polygon).norm() / 2;
}

template Corners<double> corners_of(const Surface&);
template Corners<long double> corners_of(const Surface&);
template BoundedValue<double> polygon_exchange_area(Corners<double>, Corners<double>);
template BoundedValue<long double> polygon_exchange_area(Corners<long double>, Corners<long double>);
template double polygon_area(const Corners<double>&);
template long double polygon_area(const Corners<long double>&);

}  // namespace ff

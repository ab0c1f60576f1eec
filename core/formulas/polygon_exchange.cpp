#include "core/formulas/polygon_exchange.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace ff {
namespace {

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
    return {polygon[0], twice_area(polygon).normalized()};
}

/// The part in front of a plane. A polygon with bays may come out with edges along the plane there and back; they
/// cancel in a contour integral.
template <class Real>
Corners<Real> in_front(const Plane<Real>& plane, const Corners<Real>& polygon) {
    const auto height = [&](const Vector3<Real>& x) { return plane.height(x); };
    if (std::none_of(polygon.begin(), polygon.end(), [&](const auto& x) { return height(x) > 0; })) return {};
    return part_above(polygon, height);
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
    for (const Eigen::Vector3d& corner : outline(surface)) result.push_back(corner.template cast<Real>());
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
        const DirectedEdge<Real> edge{from[i], next_corner(from, i)};
        for (std::size_t j = 0; j < to.size(); ++j) {
            const auto term = log_distance_integral<Real>(edge, {to[j], next_corner(to, j)});
            sum.value += term.value;
            sum.error += term.error;
        }
    }
    const Real scale = unit * unit / (2 * std::numbers::pi_v<Real>);
    return {std::max(Real{0}, sum.value) * scale, sum.error * scale};
}

template Corners<double> corners_of(const Surface&);
template Corners<long double> corners_of(const Surface&);
template BoundedValue<double> polygon_exchange_area(Corners<double>, Corners<double>);
template BoundedValue<long double> polygon_exchange_area(Corners<long double>, Corners<long double>);

}  // namespace ff

#include "core/formulas/polygon_exchange.hpp"

#include "core/formulas/limits.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/support/contract.hpp"

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace ff {
namespace {

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// An edge by arc length: begin + s * direction, 0 <= s <= length.
template <class Real>
struct EdgeLine {
    Vector3<Real> begin;
    Vector3<Real> direction;
    Real length = 0;

    explicit EdgeLine(const DirectedEdge<Real>& edge)
        : begin(edge.begin), direction(edge.end - edge.begin), length(direction.norm()) {
        if (length > 0) direction /= length;
    }
};

/// The integral of ln r + 1 over the points of a line, from a place.
template <class Real>
Real integral_from(const Vector3<Real>& place, const EdgeLine<Real>& line) {
    const Vector3<Real> from_begin = place - line.begin;
    const Real foot = from_begin.dot(line.direction);
    const Vector3<Real> height = from_begin - foot * line.direction;
    const Real hh = height.squaredNorm();
    const Real h = std::sqrt(hh);
    const auto antiderivative = [&](Real x) { return x / 2 * limited_log(x * x + hh) + x_atan(h, x); };
    return antiderivative(line.length - foot) + antiderivative(foot);
}

/// The closed form for parallel lines; `s` and `t` are the ends along the common direction, `apart` the lines'
/// distance.
template <class Real>
BoundedValue<Real> parallel_integral(std::array<Real, 2> s, std::array<Real, 2> t, Real apart) {
    const Real pp = apart * apart;
    BoundedValue<Real> sum;
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            const Real u = s[i] - t[j];
            const Real term = (u * u - pp) / 4 * limited_log(u * u + pp) + u * x_atan(apart, u) - u * u / 4;
            sum.value += i == j ? -term : term;
            sum.error += 8 * epsilon<Real> * std::abs(term);
        }
    }
    return sum;
}

/// Gauss's rule for one panel, from -1 to 1, and the ellipse of analyticity (half the sum of its axes) that makes its
/// error a few units of rounding.
template <class Real>
struct PanelRule {
    Real ellipse;
    std::span<const Real> nodes;  ///< those that are not negative
    std::span<const Real> weights;
    Real truncation;  ///< error per bound of the integrand in the ellipse

    template <unsigned count>
    static PanelRule of(Real ellipse) {
        using Gauss = boost::math::quadrature::gauss<Real, count>;
        return {ellipse, Gauss::abscissa(), Gauss::weights(),
                Real{64} / 15 * std::pow(ellipse, Real{-2} * count) / (1 - 1 / (ellipse * ellipse))};
    }

    template <class Integrand>
    [[nodiscard]] Real integral(const Integrand& integrand, Real middle, Real half) const {
        Real sum = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            sum += weights[k] * integrand(middle + half * nodes[k]);
            if (nodes[k] > 0) sum += weights[k] * integrand(middle - half * nodes[k]);
        }
        return half * sum;
    }
};

/// From the most nodes on.
template <class Real>
const std::vector<PanelRule<Real>>& panel_rules();
template <>
const std::vector<PanelRule<double>>& panel_rules() {
    using Panel = PanelRule<double>;
    static const std::vector rules{Panel::of<20>(2.8), Panel::of<15>(4), Panel::of<10>(8), Panel::of<7>(19),
                                   Panel::of<5>(64)};
    return rules;
}
template <>
const std::vector<PanelRule<long double>>& panel_rules() {
    static const std::vector rules{PanelRule<long double>::of<30>(2.3L)};
    return rules;
}

/// Lines that are not parallel: quadrature over the first, closed form over the second.
template <class Real>
class SkewIntegral {
  public:
    SkewIntegral(const EdgeLine<Real>& outer, const EdgeLine<Real>& inner) : outer_(outer), inner_(inner) {
        const Vector3<Real> between = inner.begin - outer.begin;
        const Vector3<Real> across = outer.direction.cross(inner.direction);
        const Real squared_sine = across.squaredNorm();
        singularities_[0] = {between.cross(inner.direction).dot(across) / squared_sine,
                             between.dot(across) / squared_sine};
        for (const Real end : {Real{0}, inner.length}) {
            const Vector3<Real> from_begin = between + end * inner.direction;
            singularities_[end > 0 ? 2 : 1] = {from_begin.dot(outer.direction),
                                               from_begin.cross(outer.direction).norm()};
        }
        add_panels(0, outer.length);
    }

    [[nodiscard]] BoundedValue<Real> integral() const { return integral_; }

  private:
    static constexpr Real widest = 6;

    /// The integral over the inner line from a point of the outer one.
    [[nodiscard]] Real inner_integral(Real s) const {
        return integral_from<Real>(outer_.begin + s * outer_.direction, inner_);
    }

    /// The ellipse of analyticity around a panel, a fourth smaller than the one that goes through a singularity.
    [[nodiscard]] Real ellipse_around(Real middle, Real half) const {
        Real least = std::numeric_limits<Real>::infinity();
        for (const std::complex<Real>& place : singularities_) {
            const std::complex<Real> z = (place - middle) / half;
            const Real imaginary = z.imag() * z.imag();
            const Real to_foci = std::sqrt((z.real() - 1) * (z.real() - 1) + imaginary) +
                                 std::sqrt((z.real() + 1) * (z.real() + 1) + imaginary);
            const Real axis = std::max(Real{1}, to_foci / 2);
            least = std::min(least, axis + std::sqrt(axis * axis - 1));
        }
        return least / Real{1.25};
    }

    void add_panels(Real low, Real high) {
        const Real middle = (low + high) / 2;
        const Real half = (high - low) / 2;
        // Coordinates are at most 2, and ellipses no longer than `widest`, so that |x| and |h| stay below 16 there, and
        // an ellipse keeps 0.2 of the panel's half length away from singularities: logarithms are no larger than this.
        const Real log_bound = std::log(Real{16} / (Real{0.2} * half));
        const bool is_negligible = half * half * log_bound < epsilon<Real> * outer_.length;
        const Real ellipse = ellipse_around(middle, half);
        const auto& rules = panel_rules<Real>();
        if (!is_negligible && ellipse < rules.front().ellipse) {
            add_panels(low, middle);
            add_panels(middle, high);
            return;
        }
        const PanelRule<Real>* rule = &rules.front();
        for (const PanelRule<Real>& other : rules) {
            if (other.ellipse <= ellipse && half * other.ellipse <= widest) rule = &other;
        }
        const Real value = rule->integral([&](Real s) { return inner_integral(s); }, middle, half);
        const Real bound = 2 * 16 * (log_bound + 2 * std::numbers::pi_v<Real>);
        const Real truncation = is_negligible ? 2 * half * log_bound : bound * rule->truncation;
        integral_.value += value;
        integral_.error += half * (truncation + 16 * epsilon<Real>)+4 * epsilon<Real> * std::abs(value);
    }

    EdgeLine<Real> outer_;
    EdgeLine<Real> inner_;
    std::array<std::complex<Real>, 3> singularities_;  ///< in the plane of s; their conjugates are others
    BoundedValue<Real> integral_;
};

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
BoundedValue<Real> log_distance_integral(const DirectedEdge<Real>& a, const DirectedEdge<Real>& b) {
    EdgeLine<Real> outer(a);
    EdgeLine<Real> inner(b);
    if (outer.length == 0 || inner.length == 0) return {};
    const Real cosine = outer.direction.dot(inner.direction);
    const Real product = outer.length * inner.length;
    constexpr Real rounding = 4 * epsilon<Real>;
    if (std::abs(cosine) <= rounding) return {0, rounding * product};

    BoundedValue<Real> integral;
    if (outer.direction.cross(inner.direction).norm() <= rounding) {
        const Vector3<Real> between = inner.begin - outer.begin;
        const Real start = between.dot(outer.direction);
        const Real end = start + std::copysign(inner.length, cosine);
        integral = parallel_integral<Real>({0, outer.length}, {std::min(start, end), std::max(start, end)},
                                           (between - start * outer.direction).norm());
    } else {
        if (outer.length > inner.length) std::swap(outer, inner);  // fewer panels
        integral = SkewIntegral<Real>(outer, inner).integral();
    }
    return {cosine * integral.value, std::abs(cosine) * integral.error + rounding * product};
}

double log_distance_integral(const Vector3<double>& place, const DirectedEdge<double>& edge) {
    const EdgeLine<double> line(edge);
    return line.length == 0 ? 0 : integral_from(place, line);
}

template BoundedValue<double> log_distance_integral(const DirectedEdge<double>&, const DirectedEdge<double>&);
template BoundedValue<long double> log_distance_integral(const DirectedEdge<long double>&,
                                                         const DirectedEdge<long double>&);

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

#include "core/formulas/rectangle_formulas.hpp"

#include "core/formulas/limits.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ff {
namespace {

/// The only axis along which `vector` is not 0.
std::optional<std::size_t> axis_of(const Eigen::Vector3d& vector) {
    std::optional<std::size_t> axis;
    for (std::size_t k = 0; k < 3; ++k) {
        if (vector[static_cast<Eigen::Index>(k)] == 0) continue;
        if (axis) return std::nullopt;
        axis = k;
    }
    return axis;
}

/// Distances between the ends of two intervals. With the signs below they turn a second antiderivative F of an even
/// function f into an integral over both: sum of sign * F(distance) = integral of f(x - x') dx dx'.
template <class Real>
using Distances = std::array<Real, 4>;
constexpr std::array<int, 4> second_difference{1, -1, -1, 1};

template <class Real>
Distances<Real> distances(const AxisInterval& a, const AxisInterval& b) {
    return {static_cast<Real>(std::abs(a.high - b.low)), static_cast<Real>(std::abs(a.high - b.high)),
            static_cast<Real>(std::abs(a.low - b.low)), static_cast<Real>(std::abs(a.low - b.high))};
}

template <class Real>
Real largest(const Distances<Real>& values) {
    return *std::max_element(values.begin(), values.end());
}

/// The power of two just below `length`. Dividing by it is exact, keeps squares of tiny and huge lengths in range, and
/// keeps logarithms small; the terms that it removes from them cancel in the sum over the corners.
template <class Real>
Real unit_of_length(Real length) {
    return std::scalbn(Real{1}, std::ilogb(length));
}

/// One corner term of the formula for parallel rectangles; the slants are sqrt(u^2 + z^2) and sqrt(v^2 + z^2).
template <class Real>
Real corner_term(Real u, Real u_slant, Real v, Real v_slant, Real zz) {
    return v * x_atan(u_slant, v) + u * x_atan(v_slant, u) - zz / 2 * limited_log(u * u + v * v + zz);
}

}  // namespace

std::optional<AlignedRectangle> aligned_rectangle(const Surface& surface) {
    const auto* shape = std::get_if<Parallelogram>(&surface.shape);
    if (shape == nullptr) return std::nullopt;
    const auto& [corner, edge_u, edge_v] = *shape;
    const auto axis_u = axis_of(edge_u);
    const auto axis_v = axis_of(edge_v);
    const auto axis = axis_of(surface.normal);
    if (!axis_u || !axis_v || !axis || *axis_u == *axis_v || *axis_u == *axis || *axis_v == *axis) return std::nullopt;

    AlignedRectangle rectangle;
    rectangle.axis = *axis;
    rectangle.side = surface.normal[static_cast<Eigen::Index>(*axis)] > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto component = static_cast<Eigen::Index>(k);
        const long double begin = corner[component];
        // One of the two edges is 0 along this axis, or both are.
        const long double end = begin + static_cast<long double>(edge_u[component] + edge_v[component]);
        rectangle.extent[k] = {std::min(begin, end), std::max(begin, end)};
    }
    return rectangle;
}

template <class Real>
Real parallel_corner(Real u, Real v, Real gap) {
    const Real zz = gap * gap;
    return corner_term(u, std::sqrt(u * u + zz), v, std::sqrt(v * v + zz), zz);
}

template <class Real>
Real parallel_exchange_area(const AxisInterval& x_from, const AxisInterval& y_from, const AxisInterval& x_to,
                            const AxisInterval& y_to, long double gap) {
    FF_EXPECT(gap > 0);
    Distances<Real> u = distances<Real>(x_from, x_to);
    Distances<Real> v = distances<Real>(y_from, y_to);
    Real z = static_cast<Real>(gap);
    const Real unit = unit_of_length(std::max({largest(u), largest(v), z}));
    z /= unit;
    const Real zz = z * z;
    Distances<Real> u_slant;  // sqrt(u^2 + z^2)
    Distances<Real> v_slant;
    for (std::size_t i = 0; i < 4; ++i) {
        u[i] /= unit;
        v[i] /= unit;
        u_slant[i] = std::sqrt(u[i] * u[i] + zz);
        v_slant[i] = std::sqrt(v[i] * v[i] + zz);
    }

    Real sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            sum += static_cast<Real>(second_difference[i] * second_difference[j]) *
                   corner_term(u[i], u_slant[i], v[j], v_slant[j], zz);
        }
    }
    return std::max(Real{0}, sum / (2 * std::numbers::pi_v<Real>)) * unit * unit;
}

template <class Real>
Real perpendicular_exchange_area(const AxisInterval& along_from, const AxisInterval& along_to,
                                 const AxisInterval& height_from, const AxisInterval& height_to) {
    FF_EXPECT(height_from.low >= 0 && height_to.low >= 0);
    Distances<Real> u = distances<Real>(along_from, along_to);
    const Real unit =
        unit_of_length(std::max({largest(u), static_cast<Real>(height_from.high), static_cast<Real>(height_to.high)}));
    for (Real& distance : u) {
        distance /= unit;
    }
    const std::array<Real, 2> y{static_cast<Real>(height_from.low) / unit, static_cast<Real>(height_from.high) / unit};
    const std::array<Real, 2> z{static_cast<Real>(height_to.low) / unit, static_cast<Real>(height_to.high) / unit};

    Real sum = 0;
    for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t k = 0; k < 2; ++k) {
            const Real pp = y[j] * y[j] + z[k] * z[k];
            const Real p = std::sqrt(pp);
            for (std::size_t i = 0; i < 4; ++i) {
                const Real corner = 2 * u[i] * x_atan(p, u[i]) + (u[i] * u[i] - pp) / 2 * limited_log(u[i] * u[i] + pp);
                sum += static_cast<Real>(second_difference[i] * (j == k ? 1 : -1)) * corner;
            }
        }
    }
    return std::max(Real{0}, -sum / (4 * std::numbers::pi_v<Real>)) * unit * unit;
}

template long double parallel_corner(long double, long double, long double);
template double parallel_exchange_area(const AxisInterval&, const AxisInterval&, const AxisInterval&,
                                       const AxisInterval&, long double);
template long double parallel_exchange_area(const AxisInterval&, const AxisInterval&, const AxisInterval&,
                                            const AxisInterval&, long double);
template double perpendicular_exchange_area(const AxisInterval&, const AxisInterval&, const AxisInterval&,
                                            const AxisInterval&);
template long double perpendicular_exchange_area(const AxisInterval&, const AxisInterval&, const AxisInterval&,
                                                 const AxisInterval&);

}  // namespace ff

// The corner sums of core/exact/exact.hpp against the definition of the form factor, integrated numerically: the two
// share no formula. Rectangles that touch, where quadrature fails, are in exact.cpp (contour integrals) and
// exact_properties.cpp.

#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/random_rectangles.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <rapidcheck/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

using Eigen::Vector3d;
using Rule = boost::math::quadrature::gauss<double, 15>;

/// cos cos / (pi r^2), 0 behind either surface.
double kernel(const Surface& from, const Vector3d& x, const Surface& to, const Vector3d& y) {
    const Vector3d ray = y - x;
    const double cosines = std::max(0.0, ray.dot(from.normal)) * std::max(0.0, -ray.dot(to.normal));
    const double squared_distance = ray.squaredNorm();
    return cosines / (std::numbers::pi * squared_distance * squared_distance);
}

template <class Function>
double integrate(const Parallelogram& shape, const Function& f) {
    return area(shape) *
           Rule::integrate(
               [&](double s) {
                   return Rule::integrate(
                       [&](double t) { return f(Vector3d(shape.corner + s * shape.edge_u + t * shape.edge_v)); }, 0.0,
                       1.0);
               },
               0.0, 1.0);
}

double integrated_exchange_area(const Surface& from, const Surface& to) {
    return integrate(parallelogram(from), [&](const Vector3d& x) {
        return integrate(parallelogram(to), [&](const Vector3d& y) { return kernel(from, x, to, y); });
    });
}

/// Wholly in front of, or wholly behind, the plane of the other: the kernel has no kink.
bool crosses_plane_of(const Surface& surface, const Surface& other) {
    const auto height = [&](const Vector3d& x) { return (x - parallelogram(other).corner).dot(other.normal); };
    const double begin = height(parallelogram(surface).corner);
    const double end =
        height(parallelogram(surface).corner + parallelogram(surface).edge_u + parallelogram(surface).edge_v);
    return std::min(begin, end) < 0 && std::max(begin, end) > 0;
}

RC_GTEST_PROP(ExactExchangeArea, AgreesWithQuadratureOfTheKernel, ()) {
    const auto [from, to] = *test::any_distant_pair();
    RC_PRE(!crosses_plane_of(from, to) && !crosses_plane_of(to, from));
    const double exact = exact_exchange_area(from, to).value();
    const double quadrature = integrated_exchange_area(from, to);
    RC_CLASSIFY(exact > 0, "facing");
    // 15 nodes on edges no longer than the distance leave a relative error below 4.2^-30.
    RC_ASSERT(test::same_exchange_area(exact, quadrature, test::squared_extent(from, to)));
}

TEST(IntegratedExchangeArea, NoticesAWrongExchangeArea) {
    const Surface floor = test::rectangle("0:1 0:1 0:0 +z");
    const Surface ceiling = test::rectangle("0.5:1.5 0:1 2:2 -z");
    const double quadrature = integrated_exchange_area(floor, ceiling);
    const double squared_extent = test::squared_extent(floor, ceiling);
    EXPECT_TRUE(test::same_exchange_area(exact_exchange_area(floor, ceiling).value(), quadrature, squared_extent));
    const Surface shifted = test::translated(ceiling, {1e-12, 0, 0});
    EXPECT_FALSE(test::same_exchange_area(exact_exchange_area(floor, shifted).value(), quadrature, squared_extent));
}

}  // namespace
}  // namespace ff

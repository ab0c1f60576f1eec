#include "core/formulas/far_exchange.hpp"

#include "core/exact/pair_exchange.hpp"
#include "core/formulas/polygon_exchange.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface square(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), 0};
}

/// Opposite squares with this edge, 1 apart.
BoundedValue<double> opposite(double edge) {
    return far_exchange_area(square({0, 0, 0}, {edge, 0, 0}, {0, edge, 0}),
                             square({0, 0, 1}, {0, edge, 0}, {edge, 0, 0}))
        .value_or(BoundedValue<double>{});
}

// The kernel is 1 / (pi r^4) with r^2 = 1 + x^2, and x^2, the squared offset of two places, is e^2 / 3 on average:
// F = e^2 / pi (1 - 2 e^2 / 3 + O(e^4)).
TEST(FarExchange, IsTheSeriesOfOppositeSquares) {
    for (const double edge : {1e-3, 1e-5, 1e-9}) {
        const auto area = opposite(edge);
        const double expected = std::pow(edge, 4) / std::numbers::pi * (1 - 2 * edge * edge / 3);
        EXPECT_NEAR(area.value / expected, 1, 1e-10) << edge;
        EXPECT_LT(area.error / expected, 1e-10);
        EXPECT_GT(area.error, 0);
    }
}

TEST(FarExchange, AgreesWithTheContourIntegralWithinBothErrors) {
    const Surface a{Triangle{{0, 0, 0}, {0.01, 0.002, 0}, {0.003, 0.008, 0}}, {0, 0, 1}, 0};
    const Vector3d u(0.004, -0.006, 0.003);
    const Vector3d v(-0.002, -0.005, 0.006);
    const Surface b = square({0.3, 0.2, 0.9}, u, v);
    const auto quadrature = far_exchange_area(a, b);
    ASSERT_TRUE(quadrature.has_value());
    std::vector<Vector3<long double>> from;
    std::vector<Vector3<long double>> to;
    for (const Vector3d& corner : corners(a.shape)) from.emplace_back(corner.cast<long double>());
    for (const Vector3d& corner : corners(b.shape)) to.emplace_back(corner.cast<long double>());
    const auto contour = polygon_exchange_area<long double>(from, to);
    ASSERT_GT(static_cast<double>(contour.value), 1e-12);
    EXPECT_NEAR(quadrature->value, static_cast<double>(contour.value),
                quadrature->error + static_cast<double>(contour.error));
}

TEST(FarExchange, IsEmptyForNearOrCrossingPolygons) {
    EXPECT_FALSE(far_exchange_area(square({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), square({0, 0, 9}, {0, 1, 0}, {1, 0, 0})));
    EXPECT_FALSE(far_exchange_area(square({0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}),
                                   square({0, 1, -0.005}, {0.01, 0, 0}, {0, 0, 0.01})));
}

// Squares of 1 cm at 1 km: the closed form is off by 1e-15 of a square kilometre, ten million times what the squares
// exchange.
TEST(PairExchange, KeepsItsDigitsForSmallDistantPairs) {
    Scene scene;
    scene.faces = {"a", "b"};
    scene.surfaces = {square({0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}), square({0, 0, 1000}, {0, 0.01, 0}, {0.01, 0, 0})};
    scene.surfaces[1].face = 1;
    const PairExchange exchange = pair_exchange(Occluders(scene), 0, 1, 1e-12);
    EXPECT_EQ(exchange.method, ExchangeMethod::quadrature);
    EXPECT_NEAR(exchange.area->value * 1e4, 3.18309886162570e-11, 1e-21);
    EXPECT_LT(exchange.area->error * 1e4, 1e-20);
}

}  // namespace
}  // namespace ff

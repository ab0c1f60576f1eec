#include "core/formulas/polygon_factor.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

using Eigen::Vector3d;

double factor(double x, double y, const Polygon& polygon) {
    PlanePoints points{};
    points.x[0] = x;
    points.y[0] = y;
    points.weight[0] = 1;
    points.size = 8;
    return sum_polygon_factors(points, polygon);
}

Polygon reversed(Polygon polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// The rectangle [x0, x1] x [y0, y1] at height z, seen from below.
Polygon ceiling(double x0, double x1, double y0, double y1, double z) {
    return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

/// The rectangle [x0, x1] x [z0, z1] in the plane of this y, seen from larger y.
Polygon wall(double x0, double x1, double y, double z0, double z1) {
    return {{x0, y, z0}, {x0, y, z1}, {x1, y, z1}, {x1, y, z0}};
}

/// The five other faces of the box [0,a] x [0,b] x [0,c] as its face z = 0 sees them.
std::vector<Polygon> other_faces(double a, double b, double c) {
    return {ceiling(0, a, 0, b, c),
            wall(0, a, 0, 0, c),
            reversed(wall(0, a, b, 0, c)),
            {{0, 0, 0}, {0, b, 0}, {0, b, c}, {0, 0, c}},
            {{a, 0, 0}, {a, 0, c}, {a, b, c}, {a, b, 0}}};
}

// Textbook formulas for a rectangle with one corner opposite the point, in extended precision: sums of them give any
// rectangle. They share nothing with the sum over edges.
long double parallel_corner(long double a, long double b, long double c) {
    const long double x = a / c;
    const long double y = b / c;
    const long double rx = std::sqrt(1 + x * x);
    const long double ry = std::sqrt(1 + y * y);
    return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * std::numbers::pi_v<long double>);
}

long double expected_ceiling(double x, double y, double x0, double x1, double y0, double y1, double z) {
    const auto f = [&](double a, double b) {
        return parallel_corner(static_cast<long double>(a) - x, static_cast<long double>(b) - y, z);
    };
    return f(x1, y1) - f(x0, y1) - f(x1, y0) + f(x0, y0);
}

/// A wall of width a and height c that stands on the plane at distance d, one lower corner opposite the point.
long double perpendicular_corner(long double a, long double c, long double d) {
    const long double r = std::sqrt(d * d + c * c);
    return (std::atan(a / d) - d / r * std::atan(a / r)) / (2 * std::numbers::pi_v<long double>);
}

double in(double low, double high) {
    return low + (high - low) * static_cast<double>(*rc::gen::inRange<std::uint64_t>(0, (1ULL << 53) + 1)) * 0x1p-53;
}

RC_GTEST_PROP(PolygonFactor, MatchesTheTextbookFormulaForACeiling, ()) {
    const double x = in(-2, 3), y = in(-2, 3), z = std::exp(in(-3, 3));
    const double expected = static_cast<double>(expected_ceiling(x, y, 0, 1, 0, 1, z));
    RC_ASSERT(std::abs(factor(x, y, ceiling(0, 1, 0, 1, z)) - expected) < 4e-16);
}

RC_GTEST_PROP(PolygonFactor, MatchesTheTextbookFormulaForAWallOnThePlane, ()) {
    const double x = in(-2, 3), d = std::exp(in(-20, 3)), c = std::exp(in(-3, 3));
    const auto right = static_cast<long double>(1) - x;
    const double expected = static_cast<double>(perpendicular_corner(right, c, d) + perpendicular_corner(x, c, d));
    RC_ASSERT(std::abs(factor(x, d, wall(0, 1, 0, 0, c)) - expected) < 4e-16);
}

TEST(PolygonFactor, AgreesWithTheFormulasToTheLastDigits) {
    const double right = static_cast<double>(expected_ceiling(0.25, 0.5, 0, 1, 0, 1, 1));
    const double wrong = static_cast<double>(expected_ceiling(0.25 + 1e-14, 0.5, 0, 1, 0, 1, 1));
    const double found = factor(0.25, 0.5, ceiling(0, 1, 0, 1, 1));
    EXPECT_LT(std::abs(found - right), 4e-16);
    EXPECT_GT(std::abs(found - wrong), 4e-16) << "the bound notices a point that is off by 1e-14";
}

// Triangles in any position: the double integral of the definition, cos cos / (pi r^2) over the triangle.
RC_GTEST_PROP(PolygonFactor, IsTheIntegralOfTheKernel, ()) {
    using Rule = boost::math::quadrature::gauss<double, 30>;
    const Vector3d a(in(-1, 1), in(-1, 1), in(2, 4)), b(in(-1, 1), in(-1, 1), in(2, 4)),
        c(in(-1, 1), in(-1, 1), in(2, 4));
    const Vector3d normal = (b - a).cross(c - a);  // twice the area; the front is where the vertices run left
    RC_PRE(normal.norm() > 1e-3);
    const double integral = Rule::integrate(
        [&](double s) {
            return Rule::integrate(
                [&](double t) {  // the triangle as a square, one side of which is a corner
                    const Vector3d ray = a + s * ((b - a) + t * (c - b));
                    const double r2 = ray.squaredNorm();
                    return s * ray.z() * std::max(0.0, -ray.dot(normal)) / (std::numbers::pi * r2 * r2);
                },
                0.0, 1.0);
        },
        0.0, 1.0);
    RC_CLASSIFY(integral > 0, "seen from the front");
    RC_ASSERT(std::abs(factor(0, 0, {a, b, c}) - integral) < 2e-15);
}

RC_GTEST_PROP(PolygonFactor, IsTheSumOfItsParts, ()) {
    const double x = in(0, 1), y = in(0, 1), cut = in(0, 1), z = std::exp(in(-6, 3));
    const double whole = factor(x, y, ceiling(0, 1, 0, 1, z));
    const double parts = factor(x, y, ceiling(0, cut, 0, 1, z)) + factor(x, y, ceiling(cut, 1, 0, 1, z));
    RC_ASSERT(std::abs(whole - parts) < 1e-15);
}

RC_GTEST_PROP(PolygonFactor, SumsTo1OverTheOtherFacesOfABox, ()) {
    const double a = std::exp(in(-5, 5)), b = std::exp(in(-5, 5)), c = std::exp(in(-5, 5));
    const double x = in(0, 1) * a, y = in(0, 1) * b;
    RC_PRE((x > 0 && x < a) || (y > 0 && y < b));  // in a corner a wall may be seen at any angle
    double sum = 0;
    for (const Polygon& face : other_faces(a, b, c)) sum += factor(x, y, face);
    RC_ASSERT(std::abs(sum - 1) < 2e-15);
}

TEST(PolygonFactor, SumsTo1HoweverCloseToEdgesAndCorners) {
    const auto faces = other_faces(1, 2, 3);
    for (const double dx : {0x1p-33, 0x1p-20, 1e-3, 0.5, 1 - 0x1p-33}) {
        for (const double dy : {0x1p-33, 0x1p-20, 1e-3, 1.0, 2 - 0x1p-32}) {
            double sum = 0;
            for (const Polygon& face : faces) sum += factor(dx, dy, face);
            EXPECT_NEAR(sum, 1, 1e-15) << dx << ' ' << dy;
        }
    }
}

TEST(PolygonFactor, IsTheLimitFromTheFrontOnAnEdgeOfAWall) {
    EXPECT_NEAR(factor(0.5, 0, wall(0, 1, 0, 0, 1)), 0.5, 1e-16) << "half of the hemisphere";
    EXPECT_NEAR(factor(0.5, 0x1p-40, wall(0, 1, 0, 0, 1)), 0.5, 1e-11);
    EXPECT_EQ(factor(1.5, 0, wall(0, 1, 0, 0, 1)), 0) << "beyond the end of the edge the wall is seen edge on";
    EXPECT_TRUE(std::isfinite(factor(0, 0, wall(0, 1, 0, 0, 1)))) << "a corner";
}

TEST(PolygonFactor, IsZeroFromBehind) {
    EXPECT_EQ(factor(0.3, 0.3, reversed(ceiling(0, 1, 0, 1, 1))), 0);
    EXPECT_EQ(factor(0.5, -1, wall(0, 1, 0, 0, 1)), 0);
    EXPECT_GT(factor(0.5, 1, wall(0, 1, 0, 0, 1)), 0);
}

TEST(PolygonFactor, WeighsAndAddsPoints) {
    PlanePoints points{};
    points.size = 16;
    double expected = 0;
    const Polygon polygon = ceiling(0, 1, 0, 1, 1);
    for (std::size_t i = 0; i < 11; ++i) {
        points.x[i] = 0.1 * static_cast<double>(i);
        points.y[i] = 0.3;
        points.weight[i] = 1.0 + static_cast<double>(i);
        expected += points.weight[i] * factor(points.x[i], points.y[i], polygon);
    }
    EXPECT_NEAR(sum_polygon_factors(points, polygon), expected, 1e-14);
}

TEST(Horizon, ClipsEverythingBelow) {
    const Polygon half = clip_at_horizon(wall(0, 1, 0, -2, 1));
    EXPECT_EQ(half.size(), 4u);
    for (const Vector3d& vertex : half) EXPECT_GE(vertex.z(), 0);
    EXPECT_NEAR(factor(0.3, 0.7, half), factor(0.3, 0.7, wall(0, 1, 0, 0, 1)), 1e-16);
    EXPECT_LT(clip_at_horizon(wall(0, 1, 0, -2, -1)).size(), 3u);
    EXPECT_EQ(clip_at_horizon(wall(0, 1, 0, 0, 1)).size(), 4u) << "touches it";
    const Polygon tip = clip_at_horizon({{0, 0, -1}, {1, 0, 1}, {-1, 0, 1}});
    EXPECT_EQ(tip.size(), 4u) << "a triangle loses a corner";
    EXPECT_EQ(clip_at_horizon({{0, 0, 1}, {1, 0, -1}, {-1, 0, -1}}).size(), 3u);
    EXPECT_EQ(factor(0.2, 0.5, clip_at_horizon(wall(0, 1, 0, -2, -1))), 0);
}

}  // namespace
}  // namespace ff

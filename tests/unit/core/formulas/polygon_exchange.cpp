// Contour integrals against formulas and definitions that share nothing with them: closed forms of aligned rectangles
// (turned, so that their edges are skew and nearly parallel), quadrature of the kernel, quadrature of the contour
// integral, sums over parts; and the stated error against the same in extended precision.

#include "core/formulas/polygon_exchange.hpp"

#include "core/exact/exact.hpp"
#include "core/formulas/rectangle_formulas.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/random_rectangles.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <Eigen/Geometry>

#include <rapidcheck/gtest.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using Polygon3 = Corners<double>;

/// Counter-clockwise as seen from the side of the normal.
Polygon3 corners_of(const Surface& surface) {
    const AlignedRectangle rectangle = aligned_rectangle(surface).value();
    const std::size_t first = (rectangle.axis + 1) % 3;
    const std::size_t second = (rectangle.axis + 2) % 3;
    Polygon3 corners;
    for (const auto& [u, v] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
        Vector3d corner;
        corner[static_cast<int>(rectangle.axis)] = static_cast<double>(rectangle.plane());
        const auto end = [](const AxisInterval& interval, int high) {
            return static_cast<double>(high != 0 ? interval.high : interval.low);
        };
        corner[static_cast<int>(first)] = end(rectangle.extent[first], u);
        corner[static_cast<int>(second)] = end(rectangle.extent[second], v);
        corners.push_back(corner);
    }
    if (rectangle.side < 0) std::reverse(corners.begin(), corners.end());
    return corners;
}

/// A number from -1 to 1 in steps of 2^-20.
rc::Gen<double> any_share() {
    return rc::gen::map(rc::gen::inRange(-(1 << 20), (1 << 20) + 1), [](int n) { return std::ldexp(n, -20); });
}

Vector3d any_vector() {
    return {*any_share(), *any_share(), *any_share()};
}

Polygon3 any_triangle() {
    Polygon3 triangle{any_vector(), any_vector(), any_vector()};
    RC_PRE(polygon_area(triangle) > 1e-3);
    return triangle;
}

Polygon3 moved(Polygon3 polygon, const Eigen::Isometry3d& motion) {
    for (Vector3d& corner : polygon) corner = motion * corner;
    return polygon;
}

Eigen::Isometry3d any_motion() {
    const Vector3d axis = any_vector();
    RC_PRE(axis.norm() > 0.1);
    return Eigen::Translation3d(any_vector()) * Eigen::AngleAxisd(3 * *any_share(), axis.normalized());
}

Corners<long double> in_long_double(const Polygon3& polygon) {
    Corners<long double> corners;
    for (const Vector3d& corner : polygon) corners.push_back(corner.cast<long double>());
    return corners;
}

/// The part of a triangle's points from which a function is taken, by Gauss's rule with 15 x 15 nodes.
template <class Function>
double integral_over(const Polygon3& triangle, const Function& f) {
    using Rule = boost::math::quadrature::gauss<double, 15>;
    const Vector3d u = triangle[1] - triangle[0];
    const Vector3d v = triangle[2] - triangle[1];
    return 2 * polygon_area(triangle) *
           Rule::integrate(
               [&](double s) {
                   return s * Rule::integrate([&](double t) { return f(Vector3d(triangle[0] + s * (u + t * v))); }, 0.0,
                                              1.0);
               },
               0.0, 1.0);
}

Vector3d normal_of(const Polygon3& triangle) {
    return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
}

/// The definition of the exchange area.
double kernel_integral(const Polygon3& from, const Polygon3& to) {
    const Vector3d normal = normal_of(from);
    const Vector3d other_normal = normal_of(to);
    return integral_over(from, [&](const Vector3d& x) {
        return integral_over(to, [&](const Vector3d& y) {
            const Vector3d ray = y - x;
            const double distance = ray.squaredNorm();
            return std::max(0.0, ray.dot(normal)) * std::max(0.0, -ray.dot(other_normal)) /
                   (std::numbers::pi * distance * distance);
        });
    });
}

/// The contour integral with its inner integral in closed form and its outer one by tanh-sinh quadrature.
double contour_integral(const Polygon3& from, const Polygon3& to) {
    boost::math::quadrature::tanh_sinh<double> rule;
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (std::size_t j = 0; j < to.size(); ++j) {
            const Vector3d& a = from[i];
            const Vector3d along = from[(i + 1) % from.size()] - a;
            const Vector3d& b = to[j];
            const Vector3d other = to[(j + 1) % to.size()] - b;
            const double length = other.norm();
            const auto inner = [&](double s) {
                const Vector3d between = a + s * along - b;
                const double foot = between.dot(other) / length;
                const double height = (between - foot * other / length).norm();
                const auto antiderivative = [&](double x) {
                    const double distance = std::hypot(x, height);
                    return (distance > 0 ? x * std::log(distance) : 0) - x +
                           (height > 0 ? height * std::atan(x / height) : 0);
                };
                return antiderivative(length - foot) - antiderivative(-foot);
            };
            if (std::abs(along.dot(other)) < 1e-14) continue;
            // Where the edge passes an end of the other one closely, the integrand changes quickly.
            std::vector<double> pieces{0, 1};
            for (const Vector3d& end : {b, Vector3d(b + other)}) {
                const double foot = (end - a).dot(along) / along.squaredNorm();
                if (foot > 1e-6 && foot < 1 - 1e-6) pieces.push_back(foot);
            }
            std::sort(pieces.begin(), pieces.end());
            for (std::size_t piece = 0; piece + 1 < pieces.size(); ++piece) {
                const double width = pieces[piece + 1] - pieces[piece];
                const auto on_piece = [&](double share) { return inner(pieces[piece] + share * width); };
                sum += along.dot(other) / length * width * rule.integrate(on_piece, 0.0, 1.0);
            }
        }
    }
    return sum / (2 * std::numbers::pi);
}

/// Whether the two differ by at most the stated error and an additional allowance.
bool agrees(const BoundedValue<double>& exchange, double expected, double allowed) {
    return std::abs(exchange.value - expected) <= exchange.error + allowed;
}

RC_GTEST_PROP(PolygonExchangeArea, MatchesTheClosedFormForTurnedRectangles, ()) {
    const Surface from = *test::any_rectangle();
    const Surface to = *test::any_rectangle();
    const double exact = exact_exchange_area(from, to).value();
    const double squared_extent = test::squared_extent(from, to);
    RC_CLASSIFY(exact > 0, "facing");
    RC_ASSERT(agrees(polygon_exchange_area<double>(corners_of(from), corners_of(to)), exact, 1e-15 * squared_extent));
    // Turned and moved by up to the extent, coordinates are rounded; edges are then parallel to within rounding only.
    const Eigen::Isometry3d motion = any_motion();
    const auto turned = polygon_exchange_area<double>(moved(corners_of(from), motion), moved(corners_of(to), motion));
    RC_ASSERT(agrees(turned, exact, 1e-14 * (squared_extent + 1)));
}

RC_GTEST_PROP(PolygonExchangeArea, MatchesTheKernelIntegralForDistantTriangles, ()) {
    const Polygon3 from = any_triangle();
    Polygon3 to = any_triangle();
    for (Vector3d& corner : to) corner += Vector3d(6, 0, 0);
    const auto in_front = [](const Polygon3& triangle, const Polygon3& plane) {
        const auto front = std::count_if(triangle.begin(), triangle.end(), [&](const Vector3d& corner) {
            return (corner - plane[0]).dot(normal_of(plane)) > 0;
        });
        return front == 0 || front == 3;  // otherwise the kernel has a kink
    };
    RC_PRE(in_front(from, to) && in_front(to, from));
    const auto exchange = polygon_exchange_area<double>(from, to);
    RC_CLASSIFY(exchange.value > 0, "facing");
    RC_ASSERT(agrees(exchange, kernel_integral(from, to), 1e-14));
    RC_ASSERT(!agrees(exchange, kernel_integral(from, to) + 1e-12, 1e-14));
}

RC_GTEST_PROP(PolygonExchangeArea, StaysWithinItsStatedError, ()) {
    const Polygon3 from = any_triangle();
    const Polygon3 to = any_triangle();
    const auto exchange = polygon_exchange_area<double>(from, to);
    const auto reference = polygon_exchange_area<long double>(in_long_double(from), in_long_double(to));
    RC_CLASSIFY(exchange.value > 0, "facing");
    // Where a triangle reaches through the plane of the other it is cut, at a place that is rounded.
    RC_ASSERT(agrees(exchange, static_cast<double>(reference.value), 1e-14));
    RC_ASSERT(reference.error <= 1e-2L * static_cast<long double>(exchange.error));  // the machine has 1 / 2048
}

RC_GTEST_PROP(PolygonExchangeArea, IsTheSameBothWaysAndTheSumOverParts, ()) {
    const Polygon3 from = any_triangle();
    const Polygon3 to = any_triangle();
    const auto whole = polygon_exchange_area<double>(from, to);
    const auto back = polygon_exchange_area<double>(to, from);
    RC_ASSERT(agrees(whole, back.value, back.error + 1e-14));
    const Vector3d middle = (to[0] + to[1]) / 2;
    const auto left = polygon_exchange_area<double>(from, {to[0], middle, to[2]});
    const auto right = polygon_exchange_area<double>(from, {middle, to[1], to[2]});
    RC_ASSERT(agrees(whole, left.value + right.value, left.error + right.error + 1e-14));
}

RC_GTEST_PROP(PolygonExchangeArea, IsTheContourIntegralWhereTrianglesTouch, ()) {
    // Both stand on the plane z = 0 with an edge or a corner at the same place, and face each other.
    const double half_angle = 0.2 + 0.6 * (*any_share() + 1);
    const Vector3d left(-std::sin(half_angle), 0, std::cos(half_angle));
    const Vector3d along(0, 1, 0);
    const double slant = *any_share();
    const double begin = *rc::gen::element(0.0, 0.25, 0.5, 1.0);
    const Polygon3 from{Vector3d(0, 0, 0), along, left + slant * along};
    const Vector3d right(std::sin(half_angle), 0, std::cos(half_angle));
    const Polygon3 to{begin * along, right, (begin + 1) * along};
    const auto exchange = polygon_exchange_area<double>(from, to);
    RC_ASSERT(exchange.value > 0);
    RC_ASSERT(agrees(exchange, contour_integral(from, to), 1e-12));
    RC_ASSERT(!agrees(exchange, contour_integral(from, to) + 1e-11, 1e-12));
}

TEST(PolygonExchangeArea, IsRightForNearlyParallelEdgesAtAnyDistance) {
    // A roof over a square, tilted by an angle about the diagonal, so that all edges are skew by about that angle.
    for (const double tilt : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-12}) {
        for (const double gap : {1.0, 1e-2, 1e-4}) {
            const double lift = std::min(tilt, gap / 2);
            const Polygon3 floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
            const Polygon3 roof{{0, 0, gap}, {0, 1, gap + lift / 2}, {1, 1, gap + lift}, {1, 0, gap + lift / 2}};
            const auto exchange = polygon_exchange_area<double>(floor, roof);
            const auto reference = polygon_exchange_area<long double>(in_long_double(floor), in_long_double(roof));
            EXPECT_TRUE(agrees(exchange, static_cast<double>(reference.value), static_cast<double>(reference.error)))
                << tilt << " " << gap << ": " << exchange.value << " +- " << exchange.error << ", "
                << static_cast<double>(reference.value) << " +- " << static_cast<double>(reference.error);
            // Only digits are lost: the bound remains useful down to the smallest angles.
            EXPECT_LT(exchange.error, 1e-13 + 4e-15 / lift) << tilt << " " << gap;
            // To this accuracy, the level roof at either height bounds the tilted one.
            const auto level = [&](double z) {
                return exact_exchange_area(test::rectangle("0:1 0:1 0:0 +z"),
                                           test::translated(test::rectangle("0:1 0:1 0:0 -z"), {0, 0, z}))
                    .value();
            };
            EXPECT_LE(exchange.value, level(gap) + exchange.error);
            EXPECT_GE(exchange.value, level(gap + lift) - exchange.error);
        }
    }
}

TEST(PolygonExchangeArea, IsZeroWhereNothingIsInFront) {
    const Polygon3 floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(polygon_exchange_area<double>(floor, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}).value, 0);     // looks away
    EXPECT_EQ(polygon_exchange_area<double>(floor, {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}).value, 0);  // below
    EXPECT_EQ(polygon_exchange_area<double>(floor, floor).value, 0);
    EXPECT_EQ(polygon_exchange_area<double>(floor, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}).value, 0);  // its own back
}

TEST(PolygonExchangeArea, HandlesBaysAndCountsOnlyThePartInFront) {
    // An L of three unit squares, the sum of its parts; tilted so that one of them is partly behind.
    const Polygon3 floor{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
    const auto at = [](double x, double y) { return Vector3d(3 - 0.5 * y, x, y - 0.25); };
    const Polygon3 bay{at(0, 0), at(0, 2), at(1, 2), at(1, 1), at(2, 1), at(2, 0)};
    const Polygon3 tall{at(0, 0), at(0, 2), at(1, 2), at(1, 0)};
    const Polygon3 low{at(1, 0), at(1, 1), at(2, 1), at(2, 0)};
    const auto whole = polygon_exchange_area<double>(floor, bay);
    const double parts =
        polygon_exchange_area<double>(floor, tall).value + polygon_exchange_area<double>(floor, low).value;
    EXPECT_GT(parts, 0.1);
    EXPECT_NEAR(whole.value, parts, 3 * whole.error);
}

}  // namespace
}  // namespace ff

#include "core/configurations/closed_forms.hpp"

#include "core/formulas/rectangle_formulas.hpp"
#include "core/support/error.hpp"
#include "tests/unit/core/configurations/extended_precision.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

namespace ff {
namespace {

using test::pi;

TEST(RectanglesAtAngle, AgreeWithTheClosedFormAtARightAngle) {
    const long double closed = perpendicular_exchange_area<long double>({0, 1}, {0, 1}, {0, 0.5}, {0, 2}) / 0.5L;
    EXPECT_PRED3(test::near, rectangles_at_angle_factor(1, 0.5, 2, pi / 2), closed, 1e-17L);
}

TEST(RectanglesAtAngle, CloseAsAPrism) {
    // Three long rectangles make a prism; its triangular ends, a contour integral of their own, get the rest. The
    // longer the prism, the closer to the endless one.
    const long double long_prism = rectangles_at_angle_factor(1e4L, 1, 1, pi / 3);
    EXPECT_PRED3(test::near, long_prism, 0.5L, 1e-4L);
    EXPECT_LT(rectangles_at_angle_factor(1, 1, 1, pi / 3), long_prism);
    EXPECT_THROW(rectangles_at_angle_factor(1, 1, 1, pi), UserError);
    EXPECT_THROW(rectangles_at_angle_factor(1, 0, 1, 1), UserError);
}

TEST(Tetrahedron, SendsAThirdToEachOtherFace) {
    EXPECT_PRED3(test::near, tetrahedron_factor(), 1 / 3.0L, 1e-17L);
}

TEST(ParallelRightTriangles, MatchTheIntegralOverAllDisplacements) {
    // Displaced by (u, v), a right triangle of legs 1 has one of legs 1 - |u + v| in common with itself where u and v
    // have the same sign, and otherwise 1 - max(|u|, |v|): twice its area times the kernel is left to integrate.
    using Rule = boost::math::quadrature::gauss<long double, 30>;
    const auto kernel = [](long double u, long double v) {
        const long double squared_distance = 1 + u * u + v * v;
        return 1 / (pi * squared_distance * squared_distance);
    };
    const auto same_sign = [&](long double u) {
        return Rule::integrate([&](long double v) { return (1 - u - v) * (1 - u - v) * kernel(u, v); }, 0, 1 - u);
    };
    const auto other_sign = [&](long double u) {
        return Rule::integrate([&](long double v) { return (1 - u) * (1 - u) * kernel(u, v); }, 0, u);
    };
    EXPECT_PRED3(test::near, parallel_right_triangles_factor(),
                 2 * Rule::integrate(same_sign, 0, 1) + 4 * Rule::integrate(other_sign, 0, 1), 1e-17L);
}

}  // namespace
}  // namespace ff

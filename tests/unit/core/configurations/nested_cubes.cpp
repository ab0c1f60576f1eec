// The opposite faces of nested cubes against the same integral with the shadow cut out by polygon clipping.

#include "core/configurations/closed_forms.hpp"

#include "core/formulas/rectangle_formulas.hpp"
#include "core/support/error.hpp"
#include "tests/unit/core/configurations/extended_precision.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector2d;
using Outline = std::vector<Vector2d>;

/// The part of a convex outline where coordinate `axis` times `sign` is at least `low`.
Outline cut(const Outline& outline, int axis, double sign, double low) {
    Outline rest;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d& a = outline[i];
        const Vector2d& b = outline[(i + 1) % outline.size()];
        const double height_a = sign * a[axis] - low;
        const double height_b = sign * b[axis] - low;
        if (height_a >= 0) rest.push_back(a);
        if (height_a * height_b < 0) rest.emplace_back(a + height_a / (height_a - height_b) * (b - a));
    }
    return rest;
}

double area_of(const Outline& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d& a = outline[i];
        const Vector2d& b = outline[(i + 1) % outline.size()];
        sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum / 2;
}

/// Starts on the lower face [0,1]^2 of rays that end (u, v) further on the upper one, u, v >= 0, and meet the cube: the
/// hull of the shadows of its lower and its upper face, within the starts of all rays.
double blocked_area(double inner, double u, double v) {
    const double low = (1 - inner) / 2;
    const double high = (1 + inner) / 2;
    const auto shadow = [&](double x, double y, double height) { return Vector2d(x - height * u, y - height * v); };
    Outline hull{shadow(low, low, high),  shadow(high, low, high), shadow(high, low, low),
                 shadow(high, high, low), shadow(low, high, low),  shadow(low, high, high)};
    hull = cut(cut(hull, 0, 1, 0), 1, 1, 0);
    return area_of(cut(cut(hull, 0, -1, u - 1), 1, -1, v - 1));
}

double blocked_share(double inner) {
    using Rule = boost::math::quadrature::gauss<double, 30>;
    // Where the shadow reaches the face's rim, and where its corner is all cut off, the area changes its formula.
    const double rim = (1 - inner) / (1 + inner);
    const double margin = (1 - inner) / 2;
    const auto f = [&](double u, double v) {
        const double squared_distance = 1 + u * u + v * v;
        return blocked_area(inner, u, v) / (std::numbers::pi * squared_distance * squared_distance);
    };
    double sum = 0;
    for (const auto& [from, to] : {std::array{0.0, rim}, std::array{rim, 1.0}}) {
        sum += Rule::integrate(
            [&, end = to](double u) {
                const auto along = [&](double v) { return f(u, v); };
                double inside = Rule::integrate(along, 0.0, rim);
                if (end == rim) return inside + Rule::integrate(along, rim, 1.0);
                const double corner = margin * u / (u - margin);
                return inside + Rule::integrate(along, rim, corner) + Rule::integrate(along, corner, 1.0);
            },
            from, to);
    }
    return 4 * sum;
}

TEST(NestedCubes, AgreeWithClippedShadows) {
    for (const double inner : {0.1, 1.0 / 3, 0.6, 0.9}) {
        const double open = static_cast<double>(parallel_exchange_area<long double>({0, 1}, {0, 1}, {0, 1}, {0, 1}, 1));
        // Areas of polygons in double: some 1e-16, times the integral of the kernel.
        EXPECT_NEAR(static_cast<double>(nested_cubes_opposite_factor(inner, 1)), open - blocked_share(inner), 2e-15);
    }
    EXPECT_GT(std::abs(blocked_share(1.0 / 3) - blocked_share(1.0 / 3 + 1e-13)), 2e-15);
}

TEST(NestedCubes, DoNotDependOnTheUnit) {
    EXPECT_PRED3(test::near, nested_cubes_opposite_factor(2, 6), nested_cubes_opposite_factor(1, 3), 1e-18L);
    const long double opposite = nested_cubes_opposite_factor(2, 6);
    EXPECT_PRED3(test::near, opposite + 4 * nested_cubes_adjacent_factor(2, 6) + 1 / 9.0L, 1, 1e-18L);
}

TEST(NestedCubes, HaveTheEmptyCubeAndASlitAsLimits) {
    EXPECT_PRED3(test::near, nested_cubes_opposite_factor(1e-6L, 1),
                 parallel_exchange_area<long double>({0, 1}, {0, 1}, {0, 1}, {0, 1}, 1), 1e-11L);
    const long double nearly_full = nested_cubes_opposite_factor(0.999L, 1);
    EXPECT_GT(nearly_full, 0);
    EXPECT_LT(nearly_full, 1e-5L);
    EXPECT_THROW(nested_cubes_opposite_factor(1, 1), UserError);
    EXPECT_THROW(nested_cubes_adjacent_factor(0, 1), UserError);
}

}  // namespace
}  // namespace ff

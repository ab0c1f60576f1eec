// Discs, spheres, cylinders, cones and elements of area against integrals of the kernel, and against each other.

#include "core/configurations/closed_forms.hpp"
#include "core/support/error.hpp"
#include "tests/unit/core/configurations/extended_precision.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace ff {
namespace {

using test::pi;
using test::Real;

/// Rounding of sums and quadratures of smooth functions in extended precision, for values below 10 as here.
constexpr Real extended_rounding = 2e-18L;

/// Gauss's rule on 16 panels: integrands are analytic at least a quarter of the interval around it, so that 30 nodes
/// leave less than 8^-60.
template <class Function>
Real integral(const Function& f, Real low, Real high) {
    constexpr int panels = 16;
    const Real width = (high - low) / panels;
    Real sum = 0;
    for (int panel = 0; panel < panels; ++panel)
        sum += boost::math::quadrature::gauss<Real, 30>::integrate(f, low + width * panel, low + width * (panel + 1));
    return sum;
}

/// Form factor from an element at a distance `aside` from the axis to a parallel disc, from its polar integral,
/// [howell] B-13.
Real element_aside_to_disc(Real radius, Real distance, Real aside) {
    const Real squares = distance * distance + aside * aside;
    const Real sum = squares + radius * radius;
    return (1 - (squares - radius * radius) / std::sqrt(sum * sum - 4 * aside * aside * radius * radius)) / 2;
}

// By the kernel over the heights of both and the angle between them; only the difference of two points' heights counts.
TEST(CoaxialCylinders, MatchTheIntegralOverTheHiddenPart) {
    for (const auto& [inner, outer, height] : {std::array<Real, 3>{1, 2, 2}, {1, 1.5, 4}, {2, 3, 1}}) {
        const auto over_heights = [&, whole = height](const auto& of_angle, Real low, Real high) {
            return integral(
                [&](Real t) {
                    return 4 * (1 - t / whole) * integral([&](Real angle) { return of_angle(angle, t); }, low, high);
                },
                0, whole);
        };
        const Real r1 = inner;
        const Real r2 = outer;
        const Real rim = std::acos(r1 / r2);
        const Real to_inner = over_heights(
            [&](Real angle, Real t) {
                const Real squares = r1 * r1 + r2 * r2 - 2 * r1 * r2 * std::cos(angle) + t * t;
                return r1 * (r2 - r1 * std::cos(angle)) * (r2 * std::cos(angle) - r1) / (pi * squares * squares);
            },
            0, rim);
        EXPECT_PRED3(test::near, outer_cylinder_to_inner_factor(r1, r2, height), to_inner, 100 * extended_rounding);
        const Real hidden = over_heights(
            [&](Real angle, Real t) {
                const Real rise = r2 * (1 - std::cos(angle));
                const Real squares = 2 * r2 * rise + t * t;
                return r2 * rise * rise / (pi * squares * squares);
            },
            2 * rim, pi);
        EXPECT_PRED3(test::near, outer_cylinder_to_itself_factor(r1, r2, height),
                     cylinder_wall_to_itself_factor(r2, height) - hidden, 100 * extended_rounding);
    }
    EXPECT_THROW(outer_cylinder_to_inner_factor(2, 1, 1), UserError);
    EXPECT_THROW(outer_cylinder_to_itself_factor(1, 1, 1), UserError);
}

TEST(CoaxialDiscs, MatchTheIntegralOverTheFirstDisc) {
    for (const auto& [r1, r2, h] : {std::array<Real, 3>{1, 1, 1}, {1, 2, 1}, {2, 1, 1}, {0.5, 3, 2}, {1, 1, 4}}) {
        const Real by_kernel =
            2 / (r1 * r1) *
            integral([&, r2 = r2, h = h](Real a) { return a * element_aside_to_disc(r2, h, a); }, 0, r1);
        EXPECT_PRED3(test::near, coaxial_discs_factor(r1, r2, h), by_kernel, extended_rounding)
            << r1 << " " << r2 << " " << h;
    }
}

TEST(CoaxialDiscs, KeepTheirDigitsFarApartAndCloseTogether) {
    EXPECT_PRED3(test::near, coaxial_discs_factor(1, 1, 1e8L) * 1e16L, 1, 1e-15L);       // r^2 / h^2 (1 - O(r^2 / h^2))
    EXPECT_PRED3(test::near, (1 - coaxial_discs_factor(1, 1, 1e-8L)) * 1e8L, 1, 1e-8L);  // h / r (1 - O(h))
    EXPECT_PRED3(test::near, coaxial_discs_factor(3, 1, 2) * 9, coaxial_discs_factor(1, 3, 2), extended_rounding);
}

TEST(BlockedDiscs, MatchTheIntegralOverTheVisiblePart) {
    // The part of the view that the blocker covers is seen as a disc of its own, inside the second disc.
    const auto seen = [](Real a) {
        return a * (element_aside_to_disc(1, 1, a) - element_aside_to_disc(0.25L, 0.5L, a));
    };
    EXPECT_PRED3(test::near, blocked_coaxial_discs_factor(0.5L, 1, 1, {0.25L, 0.5L}), 8 * integral(seen, 0, 0.5L),
                 extended_rounding);
    // Here the shadow just fits; a little larger, it does not, and the formula would be wrong.
    EXPECT_NO_THROW(blocked_coaxial_discs_factor(0.5L, 1, 1, {0.25L, 0.5L}));
    EXPECT_THROW(blocked_coaxial_discs_factor(0.5L, 1, 1, {0.26L, 0.5L}), UserError);
    EXPECT_THROW(blocked_coaxial_discs_factor(0.5L, 1, 1, {0.25L, 1}), UserError);
}

TEST(ElementToDisc, MatchesTheIntegralOverTheDisc) {
    for (const Real h : {0.5L, 1.0L, 3.0L}) {
        const auto kernel = [h](Real r) { return 2 * r * h * h / ((r * r + h * h) * (r * r + h * h)); };
        EXPECT_PRED3(test::near, element_to_disc_factor(1, h), integral(kernel, 0, 1), extended_rounding);
        EXPECT_PRED3(test::near, element_to_disc_factor(1, h), element_aside_to_disc(1, h, 0), extended_rounding);
    }
}

TEST(ElementToRectangle, MatchesTheIntegralOverTheRectangle) {
    for (const auto& [a, b, c] : {std::array<Real, 3>{1, 1, 1}, {2, 0.5, 1}, {1, 3, 2}}) {
        const auto over_y = [&, width = b, distance = c](Real x) {
            return integral(
                [&](Real y) {
                    const Real squared_distance = x * x + y * y + distance * distance;
                    return distance * distance / (pi * squared_distance * squared_distance);
                },
                0, width);
        };
        EXPECT_PRED3(test::near, element_to_rectangle_factor(a, b, c), integral(over_y, 0, a), extended_rounding);
    }
}

TEST(SphereToDisc, MatchesTheShareOfAllDirections) {
    for (const Real h : {0.25L, 2.0L, 50.0L}) {
        // The element 2 pi r dr is seen under a cosine h / d at a distance d.
        const auto share = [h](Real r) { return r * h / (2 * std::pow(r * r + h * h, 1.5L)); };
        EXPECT_PRED3(test::near, sphere_to_disc_factor(1, h), integral(share, 0, 1), extended_rounding);
    }
}

TEST(SphereCap, ReceivesEquallyFromEveryPoint) {
    // Inside a sphere the kernel is the same for all pairs of points: cosines are r / 2R.
    constexpr Real radius = 1.5L;
    for (const Real angle : {0.1L, 1.0L, 3.0L}) {
        const Real distance = 2 * radius * std::sin(angle / 2);
        const Real cosine = distance / (2 * radius);
        const Real kernel = cosine * cosine / (pi * distance * distance);
        EXPECT_PRED3(test::near, kernel * 2 * pi * radius * 0.5L, sphere_cap_factor(radius, 0.5L), extended_rounding);
    }
    EXPECT_EQ(sphere_cap_factor(1, 2), 1);
    EXPECT_THROW(sphere_cap_factor(1, 2.5L), UserError);
}

TEST(ConcentricSpheres, SatisfyClosure) {
    EXPECT_PRED3(test::near, outer_sphere_to_itself_factor(1, 2) + 0.25L, 1, extended_rounding);
    EXPECT_THROW(outer_sphere_to_itself_factor(2, 2), UserError);
}

TEST(Cylinder, ClosesWithItsBases) {
    for (const auto& [r, h] : {std::array<Real, 2>{1, 2}, {1, 0.01L}, {1, 100}, {3, 1}}) {
        const Real base_to_base = coaxial_discs_factor(r, r, h);
        EXPECT_PRED3(test::near, cylinder_base_to_wall_factor(r, h), 1 - base_to_base, extended_rounding);
        // The factor from the wall to a base follows by reciprocity; the two bases and the wall itself receive
        // everything.
        const Real wall_to_base = (1 - base_to_base) * r / (2 * h);
        EXPECT_PRED3(test::near, cylinder_wall_to_itself_factor(r, h), 1 - 2 * wall_to_base, 100 * extended_rounding);
    }
}

TEST(ConeWall, MatchesTheIntegralOverItsRings) {
    // A ring at a share s of the slant height sees the cone beyond any plane across the axis through that plane's disc.
    // By reciprocity with the discs of radius r s, ring to base is the derivative of what they exchange with the base.
    for (const auto& [r, h] : {std::array<Real, 2>{1, 1}, {1, 3}, {2, 0.5}}) {
        // A disc at s sees the base with A_s F; all that passes it comes from, or goes to, the wall above it.
        const auto wall_to_base = [&, radius = r, height = h](Real s) {
            const Real step = 1e-5L;  // central difference of the exchange area, error about step^2
            const auto exchange = [&](Real share) {
                return share * share * coaxial_discs_factor(share * radius, radius, (1 - share) * height);
            };
            return (exchange(s + step) - exchange(s - step)) / (2 * step);
        };
        const Real slant = std::hypot(r, h);
        const Real to_base = integral(wall_to_base, 2e-5L, 1 - 2e-5L);  // of the base's area
        EXPECT_PRED3(test::near, 1 - cone_wall_to_itself_factor(r, h), to_base * r / slant, 2e-4L);
    }
}

TEST(RoundConfigurations, RefuseInvalidLengths) {
    for (const Real wrong :
         {0.0L, -1.0L, std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::quiet_NaN()}) {
        const std::vector<std::function<Real()>> formulas{
            [&] { return coaxial_discs_factor(wrong, 1, 1); },
            [&] { return element_to_disc_factor(1, wrong); },
            [&] {
                return blocked_coaxial_discs_factor(1, 9, 1, {wrong, 0.5L});
            },
            [&] { return element_to_rectangle_factor(1, wrong, 1); },
            [&] { return sphere_to_disc_factor(1, wrong); },
            [&] { return sphere_cap_factor(wrong, 1); },
            [&] { return outer_sphere_to_itself_factor(wrong, 2); },
            [&] { return cylinder_wall_to_itself_factor(wrong, 1); },
            [&] { return cylinder_base_to_wall_factor(1, wrong); },
            [&] { return cone_wall_to_itself_factor(1, wrong); }};
        for (const auto& formula : formulas) EXPECT_THROW(formula(), UserError);
    }
}

}  // namespace
}  // namespace ff

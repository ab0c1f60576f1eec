// The closed form against the integral that it solves, by Gauss's rule on the pieces between kinks, with common lengths
// of intervals found as such.

#include "core/configurations/closed_forms.hpp"

#include "core/formulas/rectangle_formulas.hpp"
#include "core/support/error.hpp"
#include "tests/unit/core/configurations/extended_precision.hpp"
#include "tests/unit/core/configurations/intervals.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace ff {
namespace {

using test::Real;
using test::three;
using test::unit;

constexpr AxisInterval middle_half{0.25, 0.75};

/// The length of the set of starts of rays that start in `from`, end `u` further in `to`, and pass through the hole on
/// the way.
Real common_length(const AxisInterval& from, const AxisInterval& to, const AxisInterval& hole, Real fraction, Real u) {
    const Real low = std::max({from.low, to.low - u, hole.low - fraction * u});
    const Real high = std::min({from.high, to.high - u, hole.high - fraction * u});
    return std::max(Real{0}, high - low);
}

/// @pre kinks lie at multiples of `step`, within `reach` of 0
Real integral_over_rays(const AxisInterval& x_from, const AxisInterval& y_from, const AxisInterval& x_to,
                        const AxisInterval& y_to, Real gap, const Aperture& hole, Real step, Real reach) {
    using Rule = boost::math::quadrature::gauss<Real, 20>;
    const auto over = [&](auto f) {
        Real sum = 0;
        const long steps = std::lround(2 * reach / step);
        for (long k = 0; k < steps; ++k) {
            const Real low = static_cast<Real>(k) * step - reach;
            sum += Rule::integrate(f, low, low + step);
        }
        return sum;
    };
    return over([&](Real u) {
        const Real width = common_length(x_from, x_to, hole.x, hole.fraction, u);
        return width == 0 ? 0 : width * over([&](Real v) {
                                    const Real squared_distance = gap * gap + u * u + v * v;
                                    return common_length(y_from, y_to, hole.y, hole.fraction, v) * gap * gap /
                                           (test::pi * squared_distance * squared_distance);
                                });
    });
}

TEST(ExchangeAreaThroughAperture, MatchesTheIntegralOverAllRaysThatPass) {
    // Steps of a quarter keep the nearest complex singularity (a gap away) out of an ellipse of half axes sum above 16:
    // 20 nodes leave less than 16^-40.
    const Aperture square{middle_half, middle_half, 0.5};
    EXPECT_PRED3(test::near, exchange_area_through_aperture(unit, unit, unit, unit, 1, square),
                 integral_over_rays(unit, unit, unit, unit, 1, square, 0.25, 1), 1e-18L);
    // The L-shaped room: kinks of the widths at -1.5, 0, 1 and at -3, 0, 3.
    const Aperture corner{unit, three, 1.0L / 3};
    EXPECT_PRED3(test::near, exchange_area_through_aperture(three, three, unit, three, 3, corner),
                 integral_over_rays(three, three, unit, three, 3, corner, 0.5, 3), 1e-17L);
}

TEST(ExchangeAreaThroughAperture, IgnoresAPlateWhoseHoleHidesNothing) {
    constexpr AxisInterval wide{-9, 9};
    constexpr AxisInterval to{0.5, 2};
    for (const Real fraction : {0.125L, 0.5L, 0.75L}) {
        EXPECT_PRED3(test::near,
                     exchange_area_through_aperture(unit, middle_half, to, unit, 0.5, {wide, wide, fraction}),
                     parallel_exchange_area<Real>(unit, middle_half, to, unit, 0.5), 1e-17L);
    }
}

RC_GTEST_PROP(ExchangeAreaThroughAperture, IsTheSumOverPartsOfTheHole, ()) {
    const auto place = rc::gen::map(rc::gen::inRange(0, 17), [](int n) { return static_cast<Real>(n) / 8; });
    const auto interval = [&] {
        const Real low = *place;
        return AxisInterval{low, low + 0.125L + *place};
    };
    const AxisInterval x_from = interval(), y_from = interval(), x_to = interval(), y_to = interval();
    const Aperture whole{interval(), interval(), *rc::gen::element(0.25L, 0.5L, 0.7L)};
    const Real gap = 0.125L + *place;
    const Real cut = whole.x.low + (whole.x.high - whole.x.low) * 0.3L;
    Aperture left = whole;
    left.x.high = cut;
    Aperture right = whole;
    right.x.low = cut;
    const auto through = [&](const Aperture& hole) {
        return exchange_area_through_aperture(x_from, y_from, x_to, y_to, gap, hole);
    };
    RC_ASSERT(std::abs(through(whole) - through(left) - through(right)) <= 4e-17L);
    RC_ASSERT(through(whole) <= parallel_exchange_area<Real>(x_from, y_from, x_to, y_to, gap) + 4e-17L);
    // In the other direction the result is the same, seen from the other end.
    const Aperture back{whole.x, whole.y, 1 - whole.fraction};
    // NOLINTNEXTLINE(readability-suspicious-call-argument)
    RC_ASSERT(std::abs(through(whole) - exchange_area_through_aperture(x_to, y_to, x_from, y_from, gap, back)) <=
              4e-17L);
}

TEST(ExchangeAreaThroughAperture, RefusesAPlateOutsideTheGap) {
    EXPECT_THROW(exchange_area_through_aperture(unit, unit, unit, unit, 1, {middle_half, middle_half, 1}), UserError);
    EXPECT_THROW(exchange_area_through_aperture(unit, unit, unit, unit, 1, {middle_half, middle_half, 0}), UserError);
    EXPECT_THROW(exchange_area_through_aperture(unit, unit, unit, unit, 0, {middle_half, middle_half, 0.5}), UserError);
}

}  // namespace
}  // namespace ff

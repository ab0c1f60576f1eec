// Exact values of families against point-by-point factors: from a point, what is seen of the other rectangle through an
// aperture is a rectangle, whose factor is a sum of arc tangents; Gauss's rule integrates it over the pieces between
// which its edges change.

#include "core/configurations/built_in_scene.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/configurations/closed_forms.hpp"
#include "core/exact/known_factors.hpp"
#include "core/formulas/rectangle_formulas.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "tests/unit/core/configurations/intervals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ff {
namespace {

using test::three;
using test::unit;

/// Factor from an element to a parallel rectangle with one corner on its normal, sides signed.
double corner_factor(double x, double y, double gap) {
    const double sign = (x < 0) == (y < 0) ? 1 : -1;
    if (x == 0 || y == 0) return 0;
    return sign * static_cast<double>(element_to_rectangle_factor(std::abs(x), std::abs(y), gap));
}

/// The part of `to` that a point at x (in one coordinate) sees through `hole`.
AxisInterval seen(double x, const AxisInterval& to, const AxisInterval& hole, double fraction) {
    const auto project = [&](long double edge) { return x + (edge - x) / fraction; };
    return {std::max(to.low, project(hole.low)), std::min(to.high, project(hole.high))};
}

/// Where `seen` changes its formula, within `from`.
std::vector<double> breaks(const AxisInterval& from, const AxisInterval& to, const AxisInterval& hole,
                           double fraction) {
    std::vector<double> places{static_cast<double>(from.low), static_cast<double>(from.high)};
    for (const auto edge : {hole.low, hole.high}) {
        for (const auto end : {to.low, to.high}) {
            const auto place = static_cast<double>((edge - fraction * end) / (1 - fraction));
            if (place > from.low && place < from.high) places.push_back(place);
        }
    }
    // Where an edge that is seen passes through the foot of the normal, nothing special happens: the factor is smooth
    // there.
    std::sort(places.begin(), places.end());
    return places;
}

/// Exchange area between rectangles that face each other across `gap`, through a hole a fraction of the way on.
double through(const AxisInterval& x_from, const AxisInterval& y_from, const AxisInterval& x_to,
               const AxisInterval& y_to, double gap, const AxisInterval& x_hole, const AxisInterval& y_hole,
               double fraction) {
    using Rule = boost::math::quadrature::gauss<double, 40>;
    const auto from_point = [&](double x, double y) {
        const AxisInterval along = seen(x, x_to, x_hole, fraction);
        const AxisInterval across = seen(y, y_to, y_hole, fraction);
        if (along.high <= along.low || across.high <= across.low) return 0.0;
        const auto at = [&](long double u, long double v) {
            return corner_factor(static_cast<double>(u) - x, static_cast<double>(v) - y, gap);
        };
        return at(along.high, across.high) - at(along.low, across.high) - at(along.high, across.low) +
               at(along.low, across.low);
    };
    const auto over = [](const std::vector<double>& places, const auto& f) {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            if (places[i + 1] > places[i]) sum += Rule::integrate(f, places[i], places[i + 1]);
        }
        return sum;
    };
    const auto y_breaks = breaks(y_from, y_to, y_hole, fraction);
    return over(breaks(x_from, x_to, x_hole, fraction),
                [&](double x) { return over(y_breaks, [&](double y) { return from_point(x, y); }); });
}

double of_family(std::string_view scene, int from = 0, int to = 1) {
    return known_form_factor(built_in_scene(scene), from, to).value();
}

/// Rounding of some thousand terms, none above 1.
constexpr double rounding_of_sum = 4e-14;

TEST(SceneFamilies, AgreeWithPointsThatSeeThroughAHole) {
    for (const double edge : {0.1, 0.25, 0.5, 0.8, 1.0}) {
        const AxisInterval hole{0.5L - edge / 2, 0.5L + edge / 2};
        const double exchange = through(unit, unit, unit, unit, 1, hole, hole, 0.5);
        EXPECT_NEAR(of_family("squares_through_aperture:" + std::to_string(edge)), exchange, rounding_of_sum) << edge;
        EXPECT_NEAR(of_family("squares_blocked:" + std::to_string(edge)), of_family("cube_opposite_faces") - exchange,
                    rounding_of_sum)
            << edge;
    }
    for (const double depth : {0.25, 1.0, 2.0, 5.0}) {
        const double exchange = through(three, three, unit, three, 1 + depth, unit, three, 1 / (1 + depth));
        EXPECT_NEAR(of_family("l_shaped_room:" + std::to_string(depth)), exchange / 9, rounding_of_sum) << depth;
    }
    // The comparison notices a hole that is a millionth larger.
    const AxisInterval larger{0.25L, 0.750001L};
    EXPECT_GT(through(unit, unit, unit, unit, 1, larger, larger, 0.5) - of_family("squares_through_aperture:0.5"),
              rounding_of_sum);
}

TEST(SceneFamilies, RangeFromUnoccludedToFullyOccluded) {
    EXPECT_DOUBLE_EQ(of_family("squares_blocked:0"), of_family("cube_opposite_faces"));
    EXPECT_NEAR(of_family("squares_blocked:1"), 0, 1e-17);
    EXPECT_EQ(of_family("squares_through_aperture:0"), 0);
    EXPECT_DOUBLE_EQ(of_family("squares_through_aperture:1"), of_family("cube_opposite_faces"));
    EXPECT_EQ(built_in_scene("squares_blocked:0").surfaces.size(), 2u);
    EXPECT_EQ(built_in_scene("squares_through_aperture:1").surfaces.size(), 2u);
}

TEST(SceneFamilies, AreClosedWhereAllFactorsOfAFaceAreKnown) {
    // Factors between the two cubes do not use the formula for faces seen past the inner one.
    for (const std::string scene : {"nested_cubes:0.5", "nested_cubes", "nested_cubes:3", "nested_cubes:5.5"}) {
        const Scene cubes = built_in_scene(scene);
        const KnownFactors known = known_factors(cubes);
        for (int face = 0; face < 12; ++face) EXPECT_NEAR(known.row_sum(face).value(), 1, 1e-14) << scene << face;
    }
    EXPECT_FALSE(known_factors(built_in_scene("l_shaped_room")).row_sum(0));
}

TEST(SceneFamilies, IncludeTheScenesOfTheCatalogue) {
    for (const SceneFamily& family : scene_families()) {
        const std::string name(family.name);
        const Scene scene = built_in_scene(name);
        const Scene same = built_in_scene(name + ":" + std::to_string(family.of_catalogue));
        EXPECT_EQ(same.canonical, scene.canonical);
        EXPECT_EQ(same.surfaces.size(), scene.surfaces.size());
        EXPECT_EQ(family_member(scene)->measure, family.of_catalogue);
        for (const Configuration& configuration : configurations()) {
            if (!is_configuration(scene, configuration)) continue;
            EXPECT_DOUBLE_EQ(of_family(name, configuration.from, configuration.to),
                             static_cast<double>(configuration.exact()));
        }
        const double other = (family.least + family.most) / 3;
        const Scene member = built_in_scene(name + ":" + std::to_string(other));
        EXPECT_NE(member.canonical, scene.canonical);
        EXPECT_NEAR(family_member(member)->measure, other, 1e-6);
    }
    EXPECT_FALSE(family_member(built_in_scene("cube")));
    EXPECT_FALSE(family_member(built_in_scene("hemisphere")));
}

TEST(SceneFamilies, RefuseInvalidMeasures) {
    EXPECT_THROW(built_in_scene("squares_blocked:1.5"), UserError);
    EXPECT_THROW(built_in_scene("squares_blocked:-0.1"), UserError);
    EXPECT_THROW(built_in_scene("squares_blocked:nan"), UserError);
    EXPECT_THROW(built_in_scene("squares_blocked:"), UserError);
    EXPECT_THROW(built_in_scene("squares_blocked:0.5x"), UserError);
    EXPECT_THROW(built_in_scene("nested_cubes:6"), UserError);
    EXPECT_THROW(built_in_scene("hemisphere:2"), UserError);
    try {
        built_in_scene("nested_cubes:7");
        FAIL();
    } catch (const UserError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("edge of the inner cube"));
    }
}

TEST(OccludedFraction, GrowsWithTheBlocker) {
    double last = -1;
    for (const std::string edge : {"0", "0.3", "0.6", "1"}) {
        const Scene scene = built_in_scene("squares_blocked:" + edge);
        const double share = hidden_share(scene, known_factors(scene), 0, 1).value();
        EXPECT_GT(share, last);
        last = share;
    }
    EXPECT_DOUBLE_EQ(last, 1);
    const Scene half = built_in_scene("squares_blocked");
    EXPECT_NEAR(hidden_share(half, known_factors(half), 0, 1).value(), 1 - 0.099506294598985 / 0.199824895698387,
                1e-14);
    const Scene discs = built_in_scene("discs_blocked");  // no closed form for what is open
    EXPECT_FALSE(hidden_share(discs, known_factors(discs), 0, 1));
}

TEST(KnownFactors, CoverPairsThatCannotBeOccluded) {
    const KnownFactors room = known_factors(built_in_scene("l_shaped_room"));
    EXPECT_TRUE(room.at(0, 1));   // by its formula
    EXPECT_TRUE(room.at(0, 5));   // walls that meet at a right angle
    EXPECT_FALSE(room.at(1, 5));  // past the corner, and no formula of the catalogue
    const Scene cube = built_in_scene("cube");
    EXPECT_DOUBLE_EQ(known_factors(cube).at(0, 5).value(), of_family("cube_opposite_faces"));
    EXPECT_DOUBLE_EQ(known_factors(cube).row_sum(2).value(), 1);
}

}  // namespace
}  // namespace ff

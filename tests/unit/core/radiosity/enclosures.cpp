#include "core/radiosity/enclosures.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/radiosity/solver.hpp"
#include "core/radiosity/system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ff {
namespace {

using std::numbers::pi;

/// Rounding of a few operations on numbers around 1.
constexpr double rounding_near_one = 2e-15;

// Reference configurations, 17 digits and more by mpmath: self-views of concave surfaces.
TEST(Cavity, HasTheSelfViewOfConcaveSurfaces) {
    const auto self_view = [](double area, double opening) { return cavity(area, opening).factors(0, 0); };
    EXPECT_NEAR(self_view(2 * pi, pi), 0.5, rounding_near_one);                                  // hemisphere
    EXPECT_NEAR(self_view(2 * pi * 0.5, pi * (1 - 0.25)), 0.25, rounding_near_one);              // cap of height 0.5
    EXPECT_NEAR(self_view(pi * std::sqrt(2.0), pi), 0.29289321881345247560, rounding_near_one);  // cone, r = h = 1
    EXPECT_NEAR(self_view(4 * pi * 4, 4 * pi), 0.75, rounding_near_one);                         // sphere in sphere
}

TEST(ClosedCylinder, HasTheSelfViewOfItsWall) {
    const Enclosure cylinder = closed_cylinder(1, 2);
    EXPECT_NEAR(cylinder.factors(2, 2), 0.58578643762690495120, rounding_near_one);
    EXPECT_NEAR(cylinder.factors(0, 2), 0.82842712474619009760, rounding_near_one);
    EXPECT_NEAR(closed_cylinder(1, 1).factors(0, 1), 0.38196601125010515180, rounding_near_one);  // equal disks, h = r
}

TEST(EveryEnclosure, IsClosedAndReciprocal) {
    for (const Enclosure& enclosure :
         {cavity(2, 1), cavity(1, 1), closed_cylinder(1, 2), closed_cylinder(3, 0.1), closed_cylinder(0.1, 30),
          box_with_mirror(built_in_scene("cube"), 5).value(), box_with_mirror(built_in_scene("box:2x1x0.5"), 0).value(),
          box_with_mirror(built_in_scene("box:2x1x0.5"), 3).value()}) {
        const FactorProperties properties = factor_properties(enclosure.factors, enclosure.areas);
        EXPECT_LT(properties.closure_defect, 3e-14);
        EXPECT_LT(properties.reciprocity_defect, 3e-14);
        EXPECT_GE(enclosure.factors.minCoeff(), 0);
    }
}

// The two-surface solution of a cavity lit by its base alone, and a furnace with a patch that sees itself.
TEST(ConcavePatches, HaveTheirExactSolutions) {
    RadiositySystem system{cavity(2, 1).factors, Eigen::Vector2d(2, 1), Eigen::Vector2d(0.8, 0.4),
                           Eigen::Vector2d(0, 1)};
    // m_0 = r_0 (m_0 / 2 + m_1 / 2), m_1 = 1 + r_1 m_0
    const double m0 = 0.4 / (1 - 0.4 - 0.4 * 0.4);
    const Eigen::VectorXd exitance = solve_exactly(system).value();
    EXPECT_NEAR(exitance[0], m0, rounding_near_one);
    EXPECT_NEAR(exitance[1], 1 + 0.4 * m0, rounding_near_one);
    system.reflectance.setConstant(0.75);
    system.emission.setConstant(1);
    const Eigen::VectorXd furnace = solve_exactly(system).value();
    for (const double m : furnace) EXPECT_NEAR(m, 4, 4 * rounding_near_one);
}

// The image of a box continues it: a mirror on top of the cube makes a box of twice the height, with the light folded.
TEST(BoxWithMirror, IsHalfOfABoxOfTwiceTheHeight) {
    const Enclosure room = box_with_mirror(built_in_scene("cube"), 5).value();
    const Eigen::MatrixXd tall = exact_form_factors(built_in_scene("box:6x6x12")).value();
    ASSERT_EQ(room.areas.size(), 5);
    EXPECT_NEAR(room.factors(0, 0), tall(0, 5), rounding_near_one);  // the floor sees itself
    for (int side = 1; side < 5; ++side) {
        EXPECT_NEAR(room.factors(0, side), tall(0, side), rounding_near_one);
        EXPECT_NEAR(room.factors(side, 0), tall(side, 0) + tall(side, 5), rounding_near_one);
        for (int other = 1; other < 5; ++other)
            EXPECT_NEAR(room.factors(side, other), tall(side, other), rounding_near_one);
    }
    EXPECT_GT(room.factors(0, 0), 0.06);
}

TEST(BoxWithMirror, SolvesAsTheDoubledBoxDoes) {
    const Enclosure room = box_with_mirror(built_in_scene("box:2x1x0.5"), 5).value();
    RadiositySystem half{room.factors, room.areas, Eigen::VectorXd::Constant(5, 0.7), Eigen::VectorXd::Unit(5, 0)};
    const Scene scene = built_in_scene("box:2x1x1");
    RadiositySystem whole;
    whole.factors = exact_form_factors(scene).value();
    whole.areas.resize(6);
    for (int i = 0; i < 6; ++i) whole.areas[i] = face_area(scene, i);
    whole.reflectance = Eigen::VectorXd::Constant(6, 0.7);
    whole.emission = Eigen::VectorXd::Unit(6, 0) + Eigen::VectorXd::Unit(6, 5);
    const Eigen::VectorXd in_half = solve_exactly(half).value();
    const Eigen::VectorXd in_whole = solve_exactly(whole).value();
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(in_half[i], in_whole[i], 1e-13);
}

}  // namespace
}  // namespace ff

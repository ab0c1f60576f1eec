#include "core/estimators/rays/projections.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/estimator_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ff {
namespace {

double sum(const PixelDirections& pixels) {
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) sum += pixels.factor(i);
    return sum;
}

// The midpoint rule on each side of the projection: its error falls as 1 / r^2.
TEST(Hemicube, HasPixelsThatAddUpToOne) {
    EXPECT_EQ(Hemicube::pixels(768).size(), 768u);
    const double coarse = std::abs(sum(Hemicube::pixels(768)) - 1);
    const double fine = std::abs(sum(Hemicube::pixels(12288)) - 1);
    EXPECT_LT(coarse, 0.01);
    EXPECT_NEAR(coarse / fine, 16, 0.5);
}

TEST(CubicTetrahedron, HasPixelsThatAddUpToOne) {
    EXPECT_EQ(CubicTetrahedron::pixels(1488).size(), 1488u);  // r = 32
    EXPECT_LT(std::abs(sum(CubicTetrahedron::pixels(1488)) - 1), 0.01);
    EXPECT_LT(std::abs(sum(CubicTetrahedron::pixels(24384)) - 1), 0.001);
}

// One patch: the factor of the lid from the middle of the floor, four times that of a rectangle over a corner
// [howell, B-3].
TEST(Hemicube, MatchesThePointFactorFromTheMiddleOfTheFloor) {
    const Scene cube = make_box(1, 1, 1);
    const Eigen::MatrixXd factors = test::observe<Hemicube>(cube, 1, 786432).estimates;
    const double x = 0.5 / std::sqrt(1.25);
    const double exact = 4 * (2 * x * std::atan(x)) / (2 * std::numbers::pi);
    EXPECT_NEAR(factors(0, 5), exact, 1e-3);
}

TEST(Hemicube, ConvergesToFaceFactorsAsPatchesShrink) {
    const Scene cube = make_box(1, 1, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(cube);
    double before = 1;
    for (const std::uint32_t m : {1u, 4u, 16u}) {
        const double error = (test::observe<Hemicube>(cube, m, 12288).estimates - exact).cwiseAbs().maxCoeff();
        EXPECT_LT(error, before / 2) << m;
        before = error;
    }
}

TEST(Hemicube, SuggestsTheNearestValidSizes) {
    EXPECT_TRUE(Hemicube::size_problem(768).empty());
    EXPECT_EQ(Hemicube::size_problem(1000), "(a hemicube has 3 r^2 pixels, r even). Try 972 or 1200.");
    EXPECT_EQ(Hemicube::size_problem(0), "(a hemicube has 3 r^2 pixels, r even). Try 12.");
    EXPECT_EQ(CubicTetrahedron::size_problem(1000),
              "(a cubic tetrahedron has 3 r (r - 1) / 2 pixels). Try 975 or 1053.");
}

// Four times a rectangle over a corner, five times as wide as high [howell, B-3]: 0.9683. The midpoint rule falls as
// 1 / r^2 towards it.
TEST(SinglePlane, HasPixelsThatAddUpToTheShareAboveItsRim) {
    const double x = SinglePlane::reach;
    const double part = x / std::sqrt(1 + x * x);
    const double whole = 4 * (2 * part * std::atan(part)) / (2 * std::numbers::pi);
    EXPECT_NEAR(whole, 0.9683, 1e-4);
    const double coarse = std::abs(sum(SinglePlane::pixels(std::uint64_t{128} * 128)) - whole);
    const double fine = std::abs(sum(SinglePlane::pixels(std::uint64_t{512} * 512)) - whole);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(coarse / fine, 16, 0.5);
}

TEST(SinglePlane, SuggestsTheNearestValidSizes) {
    EXPECT_EQ(SinglePlane::size_problem(1024), "");
    EXPECT_EQ(SinglePlane::size_problem(1000), "(a single plane has r^2 pixels, r even). Try 900 or 1024.");
    EXPECT_NE(SinglePlane::size_problem(0), "");
}

}  // namespace
}  // namespace ff

#include "core/estimators/pairs/contour.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/estimator_trials.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

TEST(AdaptiveContour, FindsTheFactorsOfABox) {
    const Scene box = make_box(3, 2, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(box);
    double before = 1e-3;
    for (const std::uint64_t samples : {60u, 300u, 1200u}) {
        const double error = (test::observe<AdaptiveContour>(box, 1, samples).estimates - exact).cwiseAbs().maxCoeff();
        EXPECT_LT(error, before / 4) << samples;
        before = error;
    }
    EXPECT_LT(before, 1e-9);
}

// The difference of the rules overestimates the error of the better one by far, also where edges touch.
TEST(AdaptiveContour, ClaimsAtLeastItsError) {
    for (const std::uint32_t m : {1u, 2u}) {
        for (const Scene& scene : {make_box(1, 1, 1), make_box(3, 2, 1), make_box(1, 1, 0.01)}) {
            const Eigen::MatrixXd exact = *exact_form_factors(scene);
            for (const std::uint64_t samples : {60u, 120u, 600u}) {
                const Outcome outcome = test::observe<AdaptiveContour>(scene, m, samples);
                const Eigen::MatrixXd room = outcome.claims - (outcome.estimates - exact).cwiseAbs();
                EXPECT_GE(room.minCoeff(), -1e-12) << samples << ' ' << m;
                for (int i = 0; i < 6; ++i) EXPECT_EQ(outcome.claims(i, i), 0);
            }
        }
    }
}

TEST(AdaptiveContour, AcceptsTriangles) {
    const Scene scene = *configuration_scene("tetrahedron");
    EXPECT_NEAR(test::observe<AdaptiveContour>(scene, 1, 900).estimates(0, 1), 1.0 / 3, 1e-6);
}

TEST(AdaptiveContour, SuggestsTheNearestValidSizes) {
    EXPECT_EQ(AdaptiveContour::size_problem(60), "");
    EXPECT_EQ(AdaptiveContour::size_problem(90), "");
    EXPECT_EQ(AdaptiveContour::size_problem(100),
              "(it takes 60 evaluations for four edges, and 30 for each halving). Try 90 or 120.");
    EXPECT_EQ(AdaptiveContour::size_problem(0),
              "(it takes 60 evaluations for four edges, and 30 for each halving). Try 60.");
}

TEST(AdaptiveContour, RefusesNonConvexScenes) {
    EXPECT_NE(AdaptiveContour::refusal({}, *configuration_scene("squares_blocked")).find("adaptive_contour"),
              std::string::npos);
}

}  // namespace
}  // namespace ff

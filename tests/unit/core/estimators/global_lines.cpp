#include "core/estimators/rays/global_lines.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/estimator_trials.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

TEST(GlobalLines, HaveRowsThatAddUpToOneInAClosedScene) {
    for (const Scene& scene : {make_box(3, 2, 1), *configuration_scene("l_shaped_room")}) {
        const Eigen::VectorXd sums = test::observe<GlobalLines>(scene, 1, 2000).estimates.rowwise().sum();
        for (Eigen::Index i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i], 1, 1e-12) << scene.name;
    }
}

// Each face of the cube is crossed by a third of 2^18 lines, 8.7e4: the standard error of a factor is 0.0014, and each
// of 30 pairs may be off by five of them.
TEST(GlobalLines, FindTheFactorsOfACube) {
    const Scene cube = make_box(1, 1, 1);
    const Eigen::MatrixXd difference =
        test::observe<GlobalLines>(cube, 1, 1 << 18).estimates - *exact_form_factors(cube);
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 0.007);
    EXPECT_GT(difference.cwiseAbs().maxCoeff(), 1e-5);
}

TEST(GlobalLines, GiveReciprocalFactors) {
    const Scene box = make_box(2, 1, 1);
    const Eigen::MatrixXd factors = test::observe<GlobalLines>(box, 1, 1 << 16).estimates;
    // A_i F_ij and A_j F_ji are the same count over the crossings of each face, which are as their areas but for
    // chance.
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j)
            EXPECT_NEAR(face_area(box, i) * factors(i, j), face_area(box, j) * factors(j, i), 0.03) << i << j;
    }
}

// Two plates back to back in one plane: what arrives at one does not leave from the other.
TEST(GlobalLines, DoNotPassThroughPlatesThatLieOnEachOther) {
    Scene scene;
    scene.faces = {"floor", "lower", "upper", "lid"};
    const auto square = [](double z) { return Parallelogram{{0, 0, z}, {1, 0, 0}, {0, 1, 0}}; };
    for (const bool lower_first : {true, false}) {
        scene.surfaces = {{square(0), {0, 0, 1}, 0}, {square(2), {0, 0, -1}, 3}};
        scene.surfaces.insert(scene.surfaces.begin() + 1,
                              {square(1), {0, 0, lower_first ? -1.0 : 1.0}, lower_first ? 1 : 2});
        scene.surfaces.insert(scene.surfaces.begin() + 2,
                              {square(1), {0, 0, lower_first ? 1.0 : -1.0}, lower_first ? 2 : 1});
        const Eigen::MatrixXd factors = test::observe<GlobalLines>(scene, 1, 1 << 14).estimates;
        EXPECT_EQ(factors(1, 2), 0);
        EXPECT_EQ(factors(0, 2), 0);
        EXPECT_NEAR(factors(0, 1), 0.1998, 0.03);
        EXPECT_NEAR(factors(3, 2), 0.1998, 0.03);
    }
}

// The box around the scene is flat, and all lines begin beside it.
TEST(GlobalLines, FindNoExchangeInAFlatScene) {
    Scene scene;
    scene.faces = {"left", "right"};
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 1}};
    EXPECT_TRUE(test::observe<GlobalLines>(scene, 1, 1000).estimates.isZero(0));
}

TEST(GlobalLines, MeetARoundSurfaceTwice) {
    Scene scene;
    scene.faces = {"inside"};
    scene.closed = true;
    scene.surfaces = {{SphereZone{{1, 2, 3}, {0, 0, 1}, 2, -1, 1, Facing::inward}, {0, 0, 0}, 0}};
    EXPECT_NEAR(test::observe<GlobalLines>(scene, 1, 1000).estimates(0, 0), 1, 1e-12);
}

}  // namespace
}  // namespace ff

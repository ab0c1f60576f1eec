#include "core/estimators/pairs/rays_and_kernel.hpp"

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "stats/basics/moments.hpp"
#include "tests/support/estimator_trials.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/core/estimators/faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ff {
namespace {

using test::face_1;
using test::face_2;

// One point at a time: each of the two ways adds at most 1, and with the power heuristic a point placed on the target
// adds at most 1/2. The kernel alone gives values far above 2 where faces touch.
TEST(RaysAndKernel, IsBoundedWhereFacesTouch) {
    const Scene cube = make_box(1, 1, 1);
    const auto largest = [](const std::vector<double>& values) {
        return *std::max_element(values.begin(), values.end());
    };
    EXPECT_LE(largest(test::estimates<RaysAndKernel>(cube, 1, 1, 20000, face_1, face_2)), 2);
    EXPECT_LE(largest(test::estimates<RaysAndKernelPower>(cube, 1, 1, 20000, face_1, face_2)), 1.5);
    EXPECT_GT(largest(test::estimates<AreaKernel>(cube, 1, 1, 20000, face_1, face_2)), 10);
}

// 400 trials of 128 points for each pair of 2 x 2 patches, for each heuristic. Fails for a sound estimator with
// probability 2e-8; a bias of 3 %, as from weights that do not add up to 1, goes unnoticed with probability .01 at
// most.
TEST(RaysAndKernel, IsUnbiasedBetweenPatches) {
    const Scene cube = make_box(1, 1, 1);
    const double exact = *exact_form_factor(cube, face_1, face_2);
    const test::StatisticalRisk risks{.alpha = 1e-8, .detects = 0.06 * exact};
    EXPECT_TRUE(test::unbiased(test::estimates<RaysAndKernel>(cube, 2, 128, 100, face_1, face_2), exact, risks));
    EXPECT_TRUE(test::unbiased(test::estimates<RaysAndKernelPower>(cube, 2, 128, 100, face_1, face_2), exact, risks));
}

// Two distant squares: a ray hardly ever meets the other one, and the points placed on it do all the work. The share
// that the weights give to the rays is noise, and the power heuristic gives them less. The variances are those of 20000
// trials of one point, good to 10 %; without any weights their ratio would be 1.
TEST(RaysAndKernel, HasLessVarianceWithThePowerHeuristic) {
    Scene scene;
    scene.faces = {"a", "b"};
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{0, 0, 4}, {1, 0, 0}, {0, 1, 0}}, {0, 0, -1}, 1}};
    const auto spread = [](const std::vector<double>& values) { return *stats::moments_of(values).variance(); };
    EXPECT_LT(spread(test::estimates<RaysAndKernelPower>(scene, 1, 1, 20000, 0, 1)),
              0.5 * spread(test::estimates<RaysAndKernel>(scene, 1, 1, 20000, 0, 1)));
}

}  // namespace
}  // namespace ff

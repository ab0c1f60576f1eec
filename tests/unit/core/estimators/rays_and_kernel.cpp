#include "core/estimators/rays_and_kernel.hpp"

#include "core/estimators/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ff {
namespace {

constexpr int face_1 = 0, face_2 = 1;

template <class Estimator>
std::vector<double> estimates(const Scene& scene, std::uint32_t m, std::uint64_t samples, std::uint32_t trials,
                              int from, int to) {
    const test::PhiloxPoints points(samples);
    const Estimator estimator(scene, TracerChoice::automatic);
    std::vector<double> result;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        Outcome outcome;
        PatchTotals totals;
        estimator.observe(
            {.subdivision = {m}, .points = &points, .samples = samples, .options = {}, .key = {1, 2}, .trial = trial},
            outcome, totals);
        result.push_back(outcome.estimates(from, to));
    }
    return result;
}

// One point at a time: each way adds at most 1. The kernel alone gives values far above 2 where faces touch.
TEST(RaysAndKernel, IsBoundedWhereFacesTouch) {
    const Scene cube = make_box(1, 1, 1);
    const auto both = estimates<RaysAndKernel>(cube, 1, 1, 20000, face_1, face_2);
    EXPECT_LE(*std::max_element(both.begin(), both.end()), 2);
    const auto kernel = estimates<AreaKernel>(cube, 1, 1, 20000, face_1, face_2);
    EXPECT_GT(*std::max_element(kernel.begin(), kernel.end()), 10);
}

// 400 trials of 128 points for each pair of 2 x 2 patches. Fails for a right estimator with probability 1e-8; a bias of
// 3 % goes unnoticed with probability .01 at most.
TEST(RaysAndKernel, TellsPatchesApart) {
    const Scene cube = make_box(1, 1, 1);
    const double exact = *exact_form_factor(cube, face_1, face_2);
    EXPECT_TRUE(test::unbiased(estimates<RaysAndKernel>(cube, 2, 128, 400, face_1, face_2), exact,
                               {.alpha = 1e-8, .detects = 0.03 * exact}));
}

}  // namespace
}  // namespace ff

#include "core/configurations/built_in_scene.hpp"
#include "core/estimators/points/point_to_polygon.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "samplers/sampler.hpp"

#include <gtest/gtest.h>

// The exact bias of origins in the middle of patches: every direction from there counts, so that the expectation of a
// patch's estimate is the factor from a differential area at its middle.

namespace ff {
namespace {

Eigen::MatrixXd bias_of_patch_centres(const Scene& scene, std::uint32_t m) {
    const auto points = samplers::find("patch_centres").make({.points = 1});
    const auto expected = point_to_polygon(scene, {.m = m}, *points, 1, Allocation::patch, {1, 2}, 0);
    return expected - *exact_form_factors(scene);
}

TEST(PatchCentres, AreBiasedAsDocumented) {
    const Scene cube = built_in_scene("cube");
    const auto fine = bias_of_patch_centres(cube, 13);
    EXPECT_NEAR(fine(0, 5), 1.785e-4, 5e-8);
    EXPECT_NEAR(fine(0, 1), -4.46e-5, 5e-8);
    const auto coarse = bias_of_patch_centres(cube, 5);
    EXPECT_NEAR(coarse(0, 5), 1.216e-3, 5e-7);
    EXPECT_NEAR(coarse(0, 1), -3.04e-4, 5e-7);
}

}  // namespace
}  // namespace ff

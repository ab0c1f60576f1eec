#include "studies/analysis/analysis.hpp"

#include "core/exact/exact.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ff::studies {
namespace {

Store shoot(const char* sampler, int m) {
    return test::run(test::plan_of(test::study_text("trials = 400", fmt::format(R"([[method]]
name = "rays"
sampler = "{}"
estimator = "ray_shooting"
patches_per_face = {}
samples_per_patch = 81
)",
                                                                                sampler, m * m))));
}

/// Independent rays: Var F_pj = F_pj (1 - F_pj) / n. The mean square over 270 patch-face pairs of 400 trials has a
/// relative standard error of about 1 %.
TEST(PatchErrors, AreBinomialForIndependentRays) {
    const Store store = shoot("random", 3);
    const auto errors = patch_errors(store, 0);
    ASSERT_TRUE(errors);
    ASSERT_EQ(errors->rmse.size(), 54u);
    const auto exact = exact_patch_to_face(store.plan().scenes[0], {3});
    double expected = 0;
    double found = 0;
    for (int p = 0; p < 54; ++p) {
        for (int face = 0; face < 6; ++face) expected += (*exact)(p, face) * (1 - (*exact)(p, face)) / 81 / 5;
        found += errors->rmse[static_cast<std::size_t>(p)] * errors->rmse[static_cast<std::size_t>(p)];
    }
    EXPECT_NEAR(found / expected, 1, 0.05);
    EXPECT_GT(errors->at_edges, 0);
    EXPECT_GT(errors->inside, 0);
    EXPECT_GE(errors->rmse[errors->worst], errors->inside);
}

TEST(PatchErrors, AreSmallerWithStratifiedRays) {
    EXPECT_LT(patch_errors(shoot("stratified", 3), 0)->inside, 0.9 * patch_errors(shoot("random", 3), 0)->inside);
}

Store integrate(const char* sampler, const char* size) {
    return test::run(test::plan_of(test::study_text("trials = 20", fmt::format(R"([[method]]
name = "kernel"
sampler = "{}"
estimator = "area_kernel"
patches_per_face = 25
{}
)",
                                                                               sampler, size))));
}

/// The kernel is unbounded where patches share an edge, and smooth elsewhere.
TEST(PatchErrors, LieAlongTheEdgesForAQuadrature) {
    const auto errors = patch_errors(integrate("gauss_legendre", "nodes = 5"), 0);
    ASSERT_TRUE(errors);
    ASSERT_EQ(errors->rmse.size(), 150u);
    EXPECT_GT(errors->at_edges, 100 * errors->inside);
    EXPECT_GT(errors->inside, 0);
}

TEST(PatchErrors, AreEmptyForEstimatesWithoutAVariance) {
    EXPECT_FALSE(analyse_cell(integrate("random", "samples_per_patch = 20"), 0).patch_errors);
    EXPECT_TRUE(analyse_cell(shoot("random", 3), 0).patch_errors);
}

TEST(PatchErrors, AreEmptyForOnePatch) {
    EXPECT_FALSE(patch_errors(shoot("random", 1), 0));
}

}  // namespace
}  // namespace ff::studies

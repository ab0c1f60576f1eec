#include "studies/claims/error_law.hpp"

#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace ff::studies {
namespace {

using test::plan_of;
using test::study_text;

/// c of the closure error c/m of PDM with these nodes, from m = 6 and 9.
ErrorLaw law(std::string_view nodes) {
    const auto plan = plan_of(study_text("trials = 2", fmt::format("[[method]]\nname = \"PDM\"\nsampler = "
                                                                   "\"gauss_legendre\"\nnodes = {}\n"
                                                                   "estimator = \"area_kernel\"\n"
                                                                   "patches_per_face = [36, 81]",
                                                                   nodes)));
    const auto laws = fit_error_laws(analyse(test::run(plan)), nullptr);
    EXPECT_EQ(laws.size(), 1u);
    return laws.at(0);
}

// Expected: an independent program's row sums for 36 and 81 patches per face, 1.051365 and 1.034243, and the constants
// of c/m that follow, to their printed digits (tests/unit/core/estimators/pdm.py makes such sums).
TEST(ErrorLaw, IsPointThreeOneOverMForPdm) {
    const ErrorLaw pdm = law("5");
    ASSERT_THAT(pdm.m, testing::ElementsAre(6.0, 9.0));
    EXPECT_NEAR(pdm.closure_errors[0], 0.051365, 5e-7);
    EXPECT_NEAR(pdm.closure_errors[1], 0.034243, 5e-7);
    EXPECT_NEAR(pdm.first_order.coefficient, 0.308, 5e-4);
    EXPECT_LT(pdm.first_order.largest_residual, 1e-3);
    EXPECT_NEAR(pdm.free->exponent, 1, 1e-3);
    EXPECT_FALSE(pdm.published);
}

TEST(ErrorLaw, IsSixOrAHundredTimesSmallerForNodesThatDoNotFaceEachOther) {
    EXPECT_NEAR(law("[5, 6]").first_order.coefficient, -0.0508, 1e-4);
    EXPECT_NEAR(law("[5, 2]").first_order.coefficient, 0.0029, 1e-4);
}

TEST(ErrorLaw, IsAlsoFoundForPrintedRowSums) {
    const auto plan = plan_of(study_text("trials = 2",
                                         "[[method]]\nname = \"PDM\"\nsampler = \"gauss_legendre\"\n"
                                         "nodes = 2\nestimator = \"area_kernel\"\npatches_per_face = 4"));
    // 1 + 0.08 / m at m = 6 and 8.
    const PublishedTables tables = parse_published_tables(R"({
      "source": "s", "scene": "cube", "methods": [{"name": "PDM", "samples": false, "completion": "direct"}],
      "tables": [{"id": "t", "title": "t",
        "columns": [{"title": "a", "method": "PDM", "patches_per_face": 36},
                    {"title": "b", "method": "PDM", "patches_per_face": 64}],
        "rows": [{"title": "1", "quantity": "sum 1", "printed": ["1.013333333", "1.010000000"]}]}]})",
                                                          "t.json");
    const auto laws = fit_error_laws(analyse(test::run(plan)), &tables);
    ASSERT_EQ(laws.size(), 1u);  // the study itself has a single size
    EXPECT_TRUE(laws[0].published);
    EXPECT_THAT(laws[0].m, testing::ElementsAre(6.0, 8.0));
    EXPECT_NEAR(laws[0].first_order.coefficient, 0.08, 1e-8);
}

TEST(ErrorLaw, NeedsADeterministicMethodWithErrors) {
    const auto plan =
        plan_of(study_text("trials = 2",
                           "[[method]]\nname = \"SR\"\nsampler = \"random\"\nestimator = "
                           "\"ray_shooting\"\npatches_per_face = [1, 4]\nsamples_per_patch = 9\n"
                           "[[method]]\nname = \"e\"\nestimator = \"closed_form\"\npatches_per_face = [1, 4]"));
    EXPECT_TRUE(fit_error_laws(analyse(test::run(plan)), nullptr).empty());
}

}  // namespace
}  // namespace ff::studies

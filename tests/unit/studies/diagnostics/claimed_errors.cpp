#include "studies/diagnostics/coverage.hpp"

#include "tests/support/box_faces.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

std::vector<ClaimedErrors> judged(std::string_view methods, int trials = 400) {
    return judge_claimed_errors(
        test::run(test::plan_of(test::study_text(fmt::format("trials = {}", trials), methods))));
}

// In 400 trials of 1000 rays, for 6 pairs, the binomial error of one run holds in 95 % of cases, within 1 % (the
// share's standard error is 0.45 %), and for no pair significantly less often.
TEST(ClaimedErrors, HoldInOneRunOfRandomRays) {
    const auto found = judged(R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 1000
)");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].claimant, Claimant::one_run);
    EXPECT_EQ(found[0].claims, 2400u);
    EXPECT_NEAR(found[0].share(), 0.95, 0.02);
    EXPECT_EQ(found[0].finding, ClaimedErrorFinding::holds);
}

// The error rate is shared by all pairs of all rows: no sound claim of a study fails, but with probability 0.05.
TEST(ClaimedErrors, AreJudgedTogether) {
    const auto found = judged(R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [512, 1024, 2048]
)",
                              20);
    ASSERT_EQ(found.size(), 6u);
    double pairs = 0;
    for (const ClaimedErrors& each : found) pairs += static_cast<double>(each.pairs);
    for (const ClaimedErrors& each : found) {
        EXPECT_DOUBLE_EQ(each.worst_share_interval.level, 1 - 0.05 / pairs);
        EXPECT_EQ(each.claims, each.pairs * 20);
    }
}

// Sobol' points err less than independent ones: what their binomial error claims holds nearly always.
TEST(ClaimedErrors, AreTooLargeInOneRunOfSobolPoints) {
    const auto found = judged(R"([[method]]
name = "SR"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = 1024
)");
    EXPECT_GT(found.at(0).share(), 0.99);
    EXPECT_LT(found.at(0).median_ratio, 0.25);
}

TEST(ClaimedErrors, CanBeRefutedByOneRunWhenAStudyStatesThem) {
    const auto text = [](double claim) {
        return fmt::format(
            "[[method]]\nname = \"P\"\nsampler = \"sobol\"\nestimator = \"point_to_polygon\"\nsamples_per_patch = "
            "64\nclaimed_error = {}\n",
            claim);
    };
    const auto large = judged(text(0.1), 20);
    ASSERT_EQ(large.size(), 2u);
    EXPECT_EQ(large[0].claimant, Claimant::study);
    EXPECT_EQ(large[0].held, large[0].claims);
    EXPECT_EQ(large[0].finding, ClaimedErrorFinding::holds);
    const auto small = judged(text(1e-9), 20);
    EXPECT_EQ(small[1].finding, ClaimedErrorFinding::fails);
    EXPECT_LT(small[1].held, small[1].claims);
    EXPECT_GT(small[1].largest_ratio, 1);
}

TEST(ClaimedErrors, AreStoredWithTheTrialsOfTheirEstimator) {
    const auto found = judged(R"([[method]]
name = "Q"
estimator = "adaptive_contour"
samples_per_patch = [60, 300]
)");
    ASSERT_EQ(found.size(), 4u);
    for (const ClaimedErrors& each : found) {
        EXPECT_EQ(each.claimant, Claimant::estimator);
        EXPECT_EQ(each.finding, ClaimedErrorFinding::holds) << each.cell;
        EXPECT_LE(each.largest_ratio, 1);
    }
}

// Made up: claims of 0.01, of which the errors of every fourth trial are twice as large.
TEST(ClaimedErrors, AreCountedPairByPair) {
    const auto plan = test::plan_of(test::study_text("trials = 40", R"([[method]]
name = "P"
sampler = "random"
estimator = "point_to_polygon"
samples_per_patch = 64
claimed_error = 0.01
)"));
    const auto found = judge_claimed_errors(test::fill(plan, [](std::size_t, std::uint64_t trial, int from, int to) {
        return (test::are_opposite(from, to) ? 0.1998249 : 0.20004378) + (from == 1 && trial % 4 == 0 ? 0.02 : 0.005);
    }));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].held, 230u);  // of 6 pairs of parallel faces one has face 1 first: 10 of its 40 do not hold
    EXPECT_EQ(found[0].worst_pair, (Quantity{QuantityKind::form_factor, 1, 6}));
    EXPECT_EQ(found[0].worst_held, 30u);
    EXPECT_NEAR(found[0].largest_ratio, 2, 0.01);
    EXPECT_NEAR(found[0].median_ratio, 0.5, 0.01);
}

}  // namespace
}  // namespace ff::studies

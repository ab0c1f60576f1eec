#include "studies/comparison/ranking.hpp"

#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/comparison/two_methods.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

/// Errors of +-scale(cell), their sign by trial.
Analysis findings_with_errors(const std::vector<double>& scales) {
    const auto plan = test::plan_of(test::study_text("trials = 70", test::two_methods));
    return analyse(test::fill(plan, [&](std::size_t cell, std::uint64_t trial, int, int) {
        return 0.2 + scales[cell] * test::wobble(trial);
    }));
}

const Rivalry& parallel_rivalry(const std::vector<Rivalry>& rivals) {
    return rivals.front();
}

TEST(Rivals, AreComparedAtTheSizeThatTheyShare) {
    const auto rivals = find_rivals(findings_with_errors({0.04, 1e-4, 0.01}), {});
    ASSERT_EQ(rivals.size(), 2u);
    EXPECT_EQ(parallel_rivalry(rivals).better, 2u);
    EXPECT_EQ(parallel_rivalry(rivals).worse, 0u);
    ASSERT_TRUE(parallel_rivalry(rivals).ratio && parallel_rivalry(rivals).interval);
    EXPECT_NEAR(*parallel_rivalry(rivals).ratio, 4, 0.1);
    EXPECT_TRUE(parallel_rivalry(rivals).interval->contains(*parallel_rivalry(rivals).ratio));
    EXPECT_TRUE(parallel_rivalry(rivals).decided());
}

TEST(Rivals, AreUndecidedWhereTheirErrorsAreAlike) {
    const auto rivals = find_rivals(findings_with_errors({0.0100, 1e-4, 0.0103}), {});
    EXPECT_FALSE(parallel_rivalry(rivals).decided());
}

TEST(Rivals, ExcludeUnrandomisedPointSets) {
    const auto plan = test::plan_of(test::study_text("trials = 70", R"([[method]]
name = "one throw"
sampler = "sobol_raw"
estimator = "ray_shooting"
samples_per_patch = 64
[[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
[[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = 64
)"));
    for (const Rivalry& rivalry : find_rivals(analyse(test::run(plan)), {})) {
        EXPECT_EQ(rivalry.better, 2u);
        EXPECT_EQ(rivalry.worse, 1u);
    }
}

TEST(Rivals, AreEmptyForASingleMethod) {
    const auto plan = test::plan_of(test::study_text("trials = 10", R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 100
)"));
    const auto rivals = find_rivals(analyse(test::run(plan)), {});
    ASSERT_EQ(rivals.size(), 2u);
    EXPECT_FALSE(parallel_rivalry(rivals).worse);
    EXPECT_FALSE(parallel_rivalry(rivals).decided());
}

/// The interval holds the true ratio as often as it says: 100 studies of ratio 1. At level 0.95 fewer than 84
/// of 100 have a probability of 2e-5; with 70 % coverage instead, 99.8 %.
TEST(Rivals, HaveIntervalsThatCoverTheTruth) {
    const auto text = test::study_text("trials = 30", R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
[[method]]
name = "B"
sampler = "random_mt"
estimator = "ray_shooting"
samples_per_patch = 64
)");
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        StudySpec spec = parse_study(text, "study.toml");
        spec.seed = Seed{seed};
        const auto rivals = find_rivals(analyse(test::run(plan_study(spec))), {});
        // Better is whichever came out better: the true ratio is 1 on either side.
        if (rivals[1].interval->contains(1.0)) ++covered;
    }
    EXPECT_GE(covered, 84);
}

}  // namespace
}  // namespace ff::studies

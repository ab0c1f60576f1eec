#include "studies/form_factors/sampled_row.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/means/mean_interval.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ff::studies::form_factors {
namespace {

SampledShare hits(const std::vector<std::uint64_t>& counts, std::uint64_t rays) {
    SampledShare share{{}, rays * counts.size(), {}, true, 0};
    for (const std::uint64_t count : counts) {
        share.means.push_back(static_cast<double>(count) / static_cast<double>(rays));
        share.met += count;
    }
    return share;
}

TEST(SampledShare, HasStudentsIntervalOfItsRandomisations) {
    const SampledShare share = hits({190, 210, 205, 195}, 1000);
    const auto student = *stats::mean_interval_t(stats::moments_of(share.means), 0.9);
    const EstimatedSum estimate = estimate_of({3, {{2, share}}}, 0.9);
    EXPECT_DOUBLE_EQ(estimate.value, 3.4);
    EXPECT_DOUBLE_EQ(estimate.unmet, 2 * none_of(4000, 0.9));
    EXPECT_DOUBLE_EQ(estimate.half_width() - estimate.unmet, student.width());
}

TEST(SampledShare, AddsUpWithinRandomisations) {
    // One share is larger by as much as the other is smaller: their sum is known.
    const EstimatedSum sum =
        estimate_of({0, {{1, hits({190, 210, 205, 195}, 1000)}, {1, hits({310, 290, 295, 305}, 1000)}}}, 0.9);
    EXPECT_DOUBLE_EQ(sum.value, 0.5);
    EXPECT_LT(sum.half_width() - sum.unmet, 1e-15);
    EXPECT_DOUBLE_EQ(sum.unmet, none_of(4000, 0.9)) << "points of both share what they may be due and not meet";
}

TEST(SampledShare, StaysUncertainWithoutHits) {
    const double unmet = stats::clopper_pearson_interval({.hits = 0, .trials = 4000}, 0.95).high;
    EXPECT_NEAR(none_of(4000, 0.95), unmet, 1e-15);
    for (const std::uint64_t count : {0U, 500U, 1000U}) {
        const EstimatedSum estimate = estimate_of({0, {{1, hits({count, count, count, count}, 1000)}}}, 0.95);
        EXPECT_NEAR(estimate.up, unmet, 1e-15) << "equal means are no evidence";
        EXPECT_NEAR(estimate.down, unmet, 1e-15);
    }
}

TEST(SampledShare, AllowsForWhatPointsMayHaveMissed) {
    SampledShare share{{0.25, 0.25, 0.25, 0.25}, 4000, {.rough = 0.1, .smooth = 7, .power = 1.5}, false, 0};
    const double p = none_of(4000, 0.95);
    EXPECT_DOUBLE_EQ(estimate_of({0, {{-2, share}}}, 0.95).half_width(), 2 * 7 * std::pow(p, 1.5));
    share.unmet.smooth = 1;
    EXPECT_DOUBLE_EQ(estimate_of({0, {{-2, share}}}, 0.95).half_width(), 2 * 0.1 * p);
    EXPECT_DOUBLE_EQ(estimate_of({0, {{-2, share}}, 0.5}, 0.95).half_width(), 0.5 + 2 * 0.1 * p);
}

/// How often the interval of 16 randomisations holds the mean of counts that are Poisson, which is what hits of small
/// things are at worst.
std::uint64_t held_of_poisson(double mean, std::uint64_t times) {
    std::mt19937_64 engine(static_cast<std::uint64_t>(1000 * mean));
    std::poisson_distribution<std::uint64_t> counts(mean / randomisations);
    std::uint64_t held = 0;
    constexpr std::uint64_t rays = 1 << 20;
    for (std::uint64_t i = 0; i < times; ++i) {
        std::vector<std::uint64_t> drawn(randomisations);
        for (std::uint64_t& count : drawn) count = counts(engine);
        const EstimatedSum estimate = estimate_of({0, {{1, hits(drawn, rays)}}}, 0.95);
        const double truth = mean / static_cast<double>(randomisations * rays);
        held += estimate.value - estimate.down <= truth && truth <= estimate.value + estimate.up;
    }
    return held;
}

// Whatever the expected number of hits: 9 means, each with 4000 repetitions and a coverage of at least 0.95; 0.93 would
// be noticed in each with probability 0.99.
TEST(SampledShare, CoversTheTruthHoweverFewHitsAreExpected) {
    for (const double mean : {0.5, 1.0, 2.0, 3.6, 5.0, 8.0, 20.0, 60.0, 200.0}) {
        EXPECT_TRUE(test::has_probability_at_least(held_of_poisson(mean, 4000), 4000, 0.95,
                                                   {.alpha = 1e-3, .detects = 0.021, .power = 0.99}))
            << mean;
    }
}

}  // namespace
}  // namespace ff::studies::form_factors

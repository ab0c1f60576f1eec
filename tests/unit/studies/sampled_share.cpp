#include "studies/form_factors/sampled_share.hpp"

#include "stats/binomial.hpp"
#include "stats/mean_interval.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

SampledShare hits(const std::vector<std::uint64_t>& counts, std::uint64_t rays) {
    SampledShare share{{}, rays * counts.size(), 0, true};
    for (const std::uint64_t count : counts) {
        share.means.push_back(static_cast<double>(count) / static_cast<double>(rays));
        share.met += count;
    }
    return share;
}

TEST(SampledShare, HasStudentsIntervalOfItsRandomisations) {
    const SampledShare share = hits({190, 210, 205, 195}, 1000);
    const auto student = *stats::mean_interval_t(stats::moments_of(share.means), 0.9);
    const Estimate estimate = estimate_of({3, {{2, share}}}, 0.9);
    EXPECT_DOUBLE_EQ(estimate.value, 3.4);
    EXPECT_DOUBLE_EQ(estimate.half_width(), student.width());
}

TEST(SampledShare, AddsUpWithinRandomisations) {
    // What one share has more, the other has less: their sum is known.
    const Estimate sum =
        estimate_of({0, {{1, hits({190, 210, 205, 195}, 1000)}, {1, hits({310, 290, 295, 305}, 1000)}}}, 0.9);
    EXPECT_DOUBLE_EQ(sum.value, 0.5);
    EXPECT_LT(sum.half_width(), 1e-15);
}

TEST(SampledShare, IsNotCertainWithoutHits) {
    const Estimate none = estimate_of({0, {{1, hits({0, 0, 0, 0}, 1000)}}}, 0.95);
    EXPECT_EQ(none.value, 0);
    EXPECT_EQ(none.down, 0);
    EXPECT_DOUBLE_EQ(none.up, stats::clopper_pearson_interval({.hits = 0, .trials = 4000}, 0.95).high);
    const Estimate all = estimate_of({0, {{1, hits({1000, 1000, 1000, 1000}, 1000)}}}, 0.95);
    EXPECT_NEAR(all.down, none.up, 1e-15);
    const Estimate hidden = estimate_of({1, {{-1, hits({0, 0, 0, 0}, 1000)}}}, 0.95);
    EXPECT_DOUBLE_EQ(hidden.down, none.up) << "a negative term turns the interval round";
    EXPECT_EQ(hidden.up, 0);
}

TEST(SampledShare, IsNoSurerOfFewHitsThanOfIndependentRays) {
    // By luck all randomisations have nearly the same few hits.
    const SampledShare few = hits({5, 5, 5, 6}, 1000);
    const auto counts = stats::clopper_pearson_interval({.hits = 21, .trials = 4000}, 0.95);
    const Estimate estimate = estimate_of({0, {{1, few}}}, 0.95);
    EXPECT_LE(estimate.value - estimate.down, counts.low + 1e-15);
    EXPECT_GE(estimate.value + estimate.up, counts.high - 1e-15);
}

TEST(SampledShare, TakesEqualMeansForNoEvidence) {
    EXPECT_GE(estimate_of({0, {{1, hits({500, 500, 500, 500}, 1000)}}}, 0.95).half_width(), 1.0 / 1000);
    SampledShare constant{{0.25, 0.25, 0.25 * (1 + 1e-16), 0.25}, 4000, 4000, false};
    EXPECT_GT(estimate_of({0, {{1, constant}}}, 0.95).half_width(), 5e-4);
}

}  // namespace
}  // namespace ff::studies

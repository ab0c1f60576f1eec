#include "studies/comparison/ranking.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace ff::studies {
namespace {

using testing::ElementsAre;

stats::Measured number(double value, double error) {
    return stats::with_error(value, error, 100);
}

TEST(GroupsApart, BeginWhereAValueDiffersFromTheFirstOfTheLastGroup) {
    const std::array values{number(5, 0.1), number(1, 0.1), number(1.1, 0.1), number(5.1, 0.1), number(9, 0.1)};
    EXPECT_THAT(groups_apart(values, 0.95), ElementsAre(1, 0, 0, 1, 2));
}

TEST(GroupsApart, HoldOnlyEqualValuesWhereNothingVaries) {
    const std::array<stats::Measured, 3> values{{{2, {}}, {1, {}}, {1, {}}}};
    EXPECT_THAT(groups_apart(values, 0.95), ElementsAre(1, 0, 0));
}

TEST(GroupsApart, AreEmptyForNoValues) {
    EXPECT_TRUE(groups_apart({}, 0.95).empty());
}

/// 14 values of the same mean are distinguished in at most 5 % of cases: 400 repetitions give 20 on average, and more
/// than 40 with probability 1e-5. Without the correction for pairs, the least and the largest differ in more than half.
TEST(GroupsApart, AreASingleGroupForIndistinguishableValues) {
    std::mt19937_64 random(20250);
    std::normal_distribution<double> normal;
    int apart = 0;
    for (int repetition = 0; repetition < 400; ++repetition) {
        std::array<stats::Measured, 14> values;
        for (stats::Measured& value : values) value = stats::with_error(normal(random), 1, 10000);
        const auto groups = groups_apart(values, 0.95);
        apart += *std::max_element(groups.begin(), groups.end()) > 0 ? 1 : 0;
    }
    EXPECT_LE(apart, 40);
}

ClassSlopes slope_of(double slope, double reach, double misfit, bool may_bend) {
    ClassSlopes found;
    found.pair_class = PairClass::parallel;
    found.rmse.slope = slope;
    found.rmse.interval = {.low = slope - reach, .high = slope + reach, .level = 0.95, .method = "", .n = 100};
    found.rmse.misfit = misfit;
    found.rmse.may_bend = may_bend;
    found.sizes.resize(1);
    found.sizes.front().trials = 1000;
    return found;
}

TEST(RankedSlopes, HaveWiderIntervalsWhereAStraightLineMayNotFit) {
    std::vector<LadderSlopes> ladders(2);
    ladders[0].classes = {slope_of(-0.5, 0.1, 3, true)};
    ladders[1].classes = {slope_of(-1, 0.1, 3, false)};
    const auto ranked = rank_slopes(ladders, 0, PairClass::parallel, 0.95).slopes;
    ASSERT_EQ(ranked.size(), 2u);
    EXPECT_EQ(ranked[0].index, 1u);
    EXPECT_NEAR(ranked[0].interval->width(), 0.2, 1e-12);
    EXPECT_NEAR(ranked[1].interval->width(), 0.6, 1e-12);
    EXPECT_EQ(ranked[1].group, 1u);
    EXPECT_FALSE(ranked[0].behind);
    ASSERT_TRUE(ranked[1].behind);
    EXPECT_TRUE(ranked[1].behind->contains(0.5));
    EXPECT_GT(ranked[1].behind->low, 0) << "by the test that groups are made with";
    ladders[0].classes.front().rmse.misfit = 10;
    EXPECT_EQ(rank_slopes(ladders, 0, PairClass::parallel, 0.95).slopes[1].group, 0u);
}

TEST(RankedSlopes, UseMediansForAllWhereOneVarianceIsInfinite) {
    std::vector<LadderSlopes> ladders(2);
    ladders[0].classes = {slope_of(-0.5, 0.1, 1, false)};
    ladders[1].classes = {slope_of(-1, 0.1, 1, false)};
    ladders[1].classes.front().rmse.variance = VarianceStatus::infinite;
    for (LadderSlopes& ladder : ladders) ladder.classes.front().median = ladder.classes.front().rmse;
    ladders[0].classes.front().median.slope = -0.75;
    const auto ranked = rank_slopes(ladders, 0, PairClass::parallel, 0.95);
    EXPECT_TRUE(ranked.of_median);
    EXPECT_EQ(ranked.slopes[1].value, -0.75);
}

}  // namespace
}  // namespace ff::studies

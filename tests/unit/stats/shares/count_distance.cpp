#include "stats/shares/count_distance.hpp"

#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

const std::vector<double> quarters{0.25, 0.25, 0.25, 0.25};

// R: o <- c(30, 20, 25, 25); 2 * sum(o * log(o / 25)) is 2.013550..., by hand 2 (30 ln 1.2 + 20 ln 0.8).
TEST(CountDistance, IsTheGStatistic) {
    const auto found = count_distance(std::vector<double>{30, 20, 25, 25}, quarters);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->statistic, 2 * (30 * std::log(1.2) + 20 * std::log(0.8)), 1e-12);
    EXPECT_EQ(found->freedom, 3);
    EXPECT_EQ(found->draws, 100);
    EXPECT_NEAR(p_above(*found, 0), chi_squared_tail(found->statistic, 3), 1e-14);
}

TEST(CountDistance, PoolsNeighboursUntilEnoughAreExpected) {
    const auto found = count_distance(std::vector<double>{1, 1, 4, 2, 12}, std::vector<double>{.05, .1, .15, .1, .6});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->freedom, 1);  // 1 + 1 + 4 of 6 expected; 2 + 12 of 14
    EXPECT_EQ(found->statistic, 0);
    EXPECT_FALSE(count_distance(std::vector<double>{1, 3}, std::vector<double>{.5, .5}));
}

TEST(CountDistance, NeverHidesImpossibleCountsByPooling) {
    const auto found = count_distance(std::vector<double>{1, 49, 50}, std::vector<double>{0, 0.5, 0.5});
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->impossible);
}

TEST(CountDistance, IsSymmetricInTwoFiles) {
    const std::vector<double> a{30, 20, 50};
    const std::vector<double> b{300, 250, 450};
    const auto ab = count_distance_of_two(a, b);
    const auto ba = count_distance_of_two(b, a);
    ASSERT_TRUE(ab && ba);
    EXPECT_NEAR(ab->statistic, ba->statistic, 1e-12);
    EXPECT_NEAR(ab->draws, 100.0 * 1000 / 1100, 1e-12);
    EXPECT_EQ(count_distance_of_two(a, a)->statistic, 0);
    EXPECT_FALSE(count_distance_of_two(a, std::vector<double>{0, 0, 0}));
}

TEST(CountDistance, IntervalEndsWhereTheTailsReachItsLevel) {
    auto found = count_distance(std::vector<double>{400, 300, 200, 100}, quarters);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->lattice, 2.0 / 250);
    const auto interval = distance_interval(*found, 0.9);
    EXPECT_NEAR(p_above(*found, interval.low), 0.05, 1e-6);
    found->statistic = std::pow(std::sqrt(found->statistic) + std::sqrt(found->lattice), 2);
    EXPECT_NEAR(p_above(*found, interval.high), 0.95, 1e-6);
    // Pearson's w of these shares is sqrt(0.2) = 0.447; G's is close to it.
    EXPECT_TRUE(interval.contains(0.447)) << interval.low << " to " << interval.high;
    const auto none = count_distance(std::vector<double>{25, 25, 25, 25}, quarters);
    EXPECT_EQ(distance_interval(*none, 0.9).low, 0);
}

TEST(CountDistance, IsUncertainForFewAgreeingEvents) {
    const auto few = count_distance(std::vector<double>{6, 6}, std::vector<double>{0.5, 0.5});
    const auto many = count_distance(std::vector<double>{6000, 6000}, std::vector<double>{0.5, 0.5});
    EXPECT_EQ(few->statistic, 0);
    EXPECT_GT(distance_interval(*few, 0.9).high, 0.5);
    EXPECT_LT(distance_interval(*many, 0.9).high, 0.03);
}

TEST(CountDistance, DetectableDistancesAreRejectedWithThePower) {
    auto found = count_distance(std::vector<double>{250, 250, 250, 250}, quarters);
    ASSERT_TRUE(found);
    const double far = detectable_distance(*found, 0.1, 0.01, 0.9);
    EXPECT_GT(far, 0.1);
    // A statistic that is just beyond the band is exceeded there with the power.
    found->statistic = 40;
    const double limit = distance_interval(*found, 0.99).low;
    EXPECT_NEAR(p_above(*found, detectable_distance(*found, limit, 0.01, 0.9)), 0.9, 0.01);
}

}  // namespace
}  // namespace ff::stats

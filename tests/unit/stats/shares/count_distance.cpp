#include "stats/shares/count_distance.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/resampling.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ff::stats {
namespace {

const std::vector<double> quarters{0.25, 0.25, 0.25, 0.25};

// from scipy.special import digamma; o = numpy.array([30, 20, 25, 25])
// (2 * o * (log(o / 25) + digamma(o) - log(o)) + 1).sum(); G itself is 2.0136.
TEST(CountDistance, IsTheGStatisticLessItsBias) {
    const auto found = count_distance(std::vector<double>{30, 20, 25, 25}, quarters);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->statistic, 1.9863339623747276, 1e-12);
    EXPECT_EQ(found->freedom, 3);
    EXPECT_EQ(found->draws, 100);
    EXPECT_EQ(found->empty, 0);
    EXPECT_NEAR(p_above(*found, 0), chi_squared_tail(found->statistic, 3), 0.01);
    const auto large = count_distance(std::vector<double>{300'600, 299'400, 299'000, 301'000},  //
                                      std::vector<double>{0.25, 0.25, 0.25, 0.25});
    EXPECT_NEAR(p_above(*large, 0), chi_squared_tail(large->statistic, 3), 1e-5);
}

TEST(CountDistance, PoolsNeighboursUntilEnoughAreExpected) {
    const auto found = count_distance(std::vector<double>{1, 1, 4, 2, 12}, std::vector<double>{.05, .1, .15, .1, .6});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->freedom, 1);  // 1 + 1 + 4 of 6 expected; 2 + 12 of 14
    EXPECT_EQ(found->statistic, 0);
    EXPECT_FALSE(count_distance(std::vector<double>{1, 3}, std::vector<double>{.5, .5}));
}

// Within a distance of 0.05 a bin of probability 1e-300 may have a share of 1.8e-6: one of 191 events then falls into
// it with a probability of 3e-4.
TEST(CountDistance, NeverHidesRefutingCountsByPooling) {
    const std::vector<double> shares{1e-300, 0.5, 0.5};
    EXPECT_EQ(refuting_bin(std::vector<double>{1, 100, 90}, shares, 0.01, 1e-4), 0u);
    EXPECT_FALSE(refuting_bin(std::vector<double>{1, 100, 90}, shares, 0.05, 1e-4));
    EXPECT_TRUE(refuting_bin(std::vector<double>{1, 100, 90}, shares, 0.05, 1e-3));
    EXPECT_FALSE(refuting_bin(std::vector<double>{0, 100, 90}, shares, 0.01, 1e-4));
    EXPECT_FALSE(refuting_bin(std::vector<double>{0, 190, 0}, shares, 0.01, 1e-4));  // enough are expected
    EXPECT_EQ(refuting_bin(std::vector<double>{1, 49, 50}, std::vector<double>{0, 0.5, 0.5}, 100, 1e-9), 0u);
    const std::vector<double> rare{0.002, 0.002, 0.996};
    EXPECT_FALSE(refuting_bin(std::vector<double>{6, 2, 992}, rare, 1e-3, 1e-4));
    EXPECT_EQ(refuting_bin(std::vector<double>{16, 2, 982}, rare, 1e-3, 1e-4), 0u);
}

TEST(CountDistance, IsSymmetricInTwoFiles) {
    const std::vector<double> a{30, 20, 50};
    const std::vector<double> b{300, 250, 450};
    const auto ab = count_distance_of_two(a, b);
    const auto ba = count_distance_of_two(b, a);
    ASSERT_TRUE(ab && ba);
    EXPECT_NEAR(ab->statistic, ba->statistic, 1e-12);
    EXPECT_NEAR(ab->draws, 100.0 * 1000 / 1100, 1e-12);
    EXPECT_NEAR(count_distance_of_two(a, a)->statistic, 0, 0.1);
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

// Their statistic is 0, below what equal distributions give except in one set of 60 events in 20.
TEST(CountDistance, IsNoSmallerForCountsThatAgreeTooWell) {
    const auto found = count_distance(std::vector<double>(10, 6), std::vector<double>(10, 0.1));
    ASSERT_LT(found->statistic, found->freedom);
    CountDistance usual = *found;
    usual.statistic = usual.freedom;
    EXPECT_GT(distance_interval(*found, 0.9).high, 0.25);
    EXPECT_LE(distance_interval(*found, 0.9).high, distance_interval(usual, 0.9).high);
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

TEST(CountDistance, JudgesCountsUpToTheLargestThatDoublesHold) {
    for (const double n : {1e9, 1e12, 1e14, 9e15}) {
        const std::vector<double> shares{0.4, 0.3, 0.3};
        const double noise = std::floor(0.4 * std::sqrt(n));
        const std::vector<double> right{std::floor(0.4 * n) + noise, std::floor(0.3 * n) - noise, std::floor(0.3 * n)};
        const std::vector<double> wrong{std::floor(0.45 * n), std::floor(0.3 * n), std::floor(0.25 * n)};
        const std::vector<double> one{n, 0, 0};
        for (const auto& [as_expected, found] :
             {std::pair(1.0, count_distance(right, shares)), std::pair(2.0, count_distance_of_two(right, right)),
              std::pair(3.0,
                        count_distance(std::vector<double>{n, n / 2, n / 2}, std::vector<double>{0.5, 0.25, 0.25}))}) {
            EXPECT_EQ(distance_interval(*found, 0.9999).low, 0) << n << ' ' << as_expected;
            EXPECT_LT(distance_interval(*found, 0.9).high, 10 / std::sqrt(n)) << n << ' ' << as_expected;
            EXPECT_NEAR(detectable_distance(*found, 0.05, 1e-4, 0.9), 0.05, 20 / std::sqrt(n));
        }
        EXPECT_NEAR(count_distance(right, shares)->statistic, 0.16 / 0.4 + 0.16 / 0.3, 0.01);
        // 2 (0.45 ln(9/8) + 0.25 ln(5/6)) and 2 ln(5/2) are the squares of these distances.
        const double far = std::sqrt(0.9 * std::log(1.125) - 0.5 * std::log(1.2));
        EXPECT_NEAR(distance_interval(*count_distance(wrong, shares), 0.9999).low, far, 10 / std::sqrt(n));
        EXPECT_NEAR(distance_interval(*count_distance(one, shares), 0.9999).high, std::sqrt(2 * std::log(2.5)),
                    10 / std::sqrt(n));
        EXPECT_GT(distance_interval(*count_distance_of_two(one, wrong), 0.9999).low, 0.5);
    }
}

/// Counts of 5 events a cell on average, where every other cell has more by the share `tilt` and the next one less.
std::vector<double> sparse_counts(std::size_t cells, double tilt, Draws& draws) {
    std::vector<double> counts(cells);
    for (std::size_t i = 0; i < 5 * cells; ++i)
        ++counts[2 * draws.below(cells / 2) + (draws.uniform() < (1 + tilt) / 2 ? 0 : 1)];
    return counts;
}

/// How often 3000 cells that differ by `tilt` refute a distance of w at 1 %, in 500 repetitions.
std::uint64_t refuted(double tilt, double w, bool of_two) {
    constexpr std::size_t cells = 3000;
    Draws draws({.word0 = 21, .word1 = 22}, Resampling::simulation, of_two ? 1 : 0);
    const std::vector<double> even(cells, 1.0 / cells);
    return test::count_events(500, [&] {
        const auto counts = sparse_counts(cells, tilt, draws);
        return p_above(of_two ? *count_distance_of_two(counts, sparse_counts(cells, 0, draws))
                              : *count_distance(counts, even),
                       w) < 0.01;
    });
}

// Seeded; false alarms of a test have a probability of 1e-6, and 99 % of them notice what `detects` says: rates above
// 0.06 instead of 0.01, which were 0.2 and more by chi-squared alone, and powers below 0.85 instead of 0.95.
TEST(CountDistance, KeepsItsLevelAndPowerInManyCellsOfFewEvents) {
    constexpr double edge = 0.3;
    const double w = std::sqrt((1 + edge) * std::log1p(edge) + (1 - edge) * std::log1p(-edge));
    EXPECT_TRUE(test::has_probability_at_most(refuted(0, 0, false), 500, 0.01, {.detects = 0.053}));
    EXPECT_TRUE(test::has_probability_at_most(refuted(0, 0, true), 500, 0.01, {.detects = 0.053}));
    EXPECT_TRUE(test::has_probability_at_most(refuted(edge, w, false), 500, 0.01, {.detects = 0.053}));
    EXPECT_TRUE(test::has_probability_at_least(refuted(0.17, 0, false), 500, 0.95, {.detects = 0.1}));
    EXPECT_TRUE(test::has_probability_at_least(refuted(0.33, 0, true), 500, 0.95, {.detects = 0.1}));
}

}  // namespace
}  // namespace ff::stats

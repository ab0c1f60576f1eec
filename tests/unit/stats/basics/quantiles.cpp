#include "stats/basics/quantiles.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

using test::eight_values;

// np.quantile([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3], [0, .05, .25, .5, .77, 1])
TEST(Quantiles, AreOfTypeSevenAsInNumpyAndR) {
    const auto result = quantiles(eight_values, std::array{0.0, 0.05, 0.25, 0.5, 0.77, 1.0});
    const std::array expected{1.9, 1.97, 2.625, 3.35, 4.868, 9.7};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(result[i], expected[i], 1e-14);
}

TEST(Quantiles, EqualASingleValue) {
    EXPECT_EQ(quantiles(std::array{7.0}, std::array{0.0, 0.3, 1.0}), (std::vector{7.0, 7.0, 7.0}));
}

/// Tied and distinct values of 1 to 40 numbers: what selection finds is what sorting finds, to the bit.
TEST(Selection, GivesTheBitsOfSorting) {
    std::mt19937_64 random(3);
    for (std::size_t n = 1; n <= 40; ++n) {
        for (const bool tied : {false, true}) {
            std::vector<double> values;
            for (std::size_t i = 0; i < n; ++i)
                values.push_back(tied ? static_cast<double>(random() % 4) / 3 : static_cast<double>(random()) / 7);
            const auto ascending = sorted(values);
            EXPECT_EQ(median(values), quantile(ascending, 0.5));
            for (std::size_t count = 0; count <= n; ++count) {
                EXPECT_EQ(largest(values, count),
                          std::vector<double>(ascending.end() - static_cast<std::ptrdiff_t>(count), ascending.end()));
            }
        }
    }
}

TEST(MedianAbsoluteError, IsMeasuredFromTheReference) {
    EXPECT_NEAR(*median_absolute_error(eight_values, 3), 1, 1e-14);  // np.median(abs(x - 3))
    EXPECT_EQ(median_absolute_error(std::array{2.0}, 5), 3);
    EXPECT_FALSE(median_absolute_error({}, 0));
}

TEST(CentralRange, HoldsTheMiddleShare) {
    std::vector<double> values(1001);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(1000 - i);
    const auto range = central_range(values, 0.95);
    EXPECT_NEAR(range->low, 25, 1e-9);
    EXPECT_NEAR(range->high, 975, 1e-9);
    EXPECT_FALSE(central_range({}, 0.95));
}

TEST(RankAmong, CountsTiesHalf) {
    const auto rank = rank_among(std::array{1.0, 2.0, 2.0, 3.0}, 2);
    EXPECT_EQ(rank->below, 1u);
    EXPECT_EQ(rank->equal, 2u);
    EXPECT_EQ(rank->percentile, 0.5);
    EXPECT_TRUE(rank->interval.contains(0.5));
    EXPECT_EQ(rank->p, 1);
    EXPECT_EQ(rank_among(std::array{1.0, 2.0, 2.04, 3.0}, 2, 0.95, 0.05)->equal, 2u);
    EXPECT_FALSE(rank_among({}, 2));
}

TEST(RankAmong, StaysUncertainBeyondTheExtremes) {
    std::vector<double> values(99, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    const auto rank = rank_among(values, 1000);
    EXPECT_EQ(rank->percentile, 1);
    EXPECT_LT(rank->interval.low, 1);
    EXPECT_EQ(rank->interval.high, 1);
    EXPECT_DOUBLE_EQ(rank->p, 0.02);  // never 0: 2 / (n + 1)
    EXPECT_DOUBLE_EQ(rank_among(values, -1)->p, 0.02);
}

// The value comes from the same distribution, so p <= alpha has probability at most alpha. Risks: 1e-6; .02 at .99.
TEST(RankAmong, GivesAValidPValue) {
    std::mt19937_64 engine(1);
    const auto rejected = test::count_events(8000, [&] {
        const auto values = test::normal_sample(99, engine);
        return rank_among(values, test::normal_sample(1, engine)[0])->p <= 0.05;
    });
    EXPECT_TRUE(test::has_probability_at_most(rejected, 8000, 0.05, {.detects = 0.02}));
    EXPECT_TRUE(test::has_probability_at_least(rejected, 8000, 0.03, {.detects = 0.02}));
}

}  // namespace
}  // namespace ff::stats

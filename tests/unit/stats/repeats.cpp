#include "stats/repeats.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::stats {
namespace {

/// Hits of `rays` rays over `rays`: multiples of 1 / rays, none of them exact in binary.
std::vector<double> counted(std::size_t n, int rays, double p, std::mt19937_64& engine) {
    std::vector<double> values;
    std::binomial_distribution<int> hits(rays, p);
    for (std::size_t i = 0; i < n; ++i) values.push_back(hits(engine) / static_cast<double>(rays));
    return values;
}

std::vector<double> printed(std::vector<double> values, double unit) {
    for (double& value : values) value = std::round(value / unit) * unit;
    return values;
}

TEST(FindRepeats, FindsNoneAmongRealNumbers) {
    std::mt19937_64 engine(1);
    EXPECT_FALSE(find_repeats(test::normal_sample(10'000, engine)));
}

TEST(FindRepeats, FindsASingleRealNumberThatOccursTwice) {
    std::mt19937_64 engine(2);
    std::vector<double> values = test::normal_sample(100, engine, 0.2, 1e-3);
    values[70] = values[3];
    const auto found = find_repeats(values);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->repeats, 1u);
    EXPECT_EQ(found->earlier, 3u);
    EXPECT_EQ(found->later, 70u);
    EXPECT_EQ(found->p, 0);
}

TEST(FindRepeats, AllowsForCountsAndForRoundedFigures) {
    std::mt19937_64 engine(3);
    for (int i = 0; i < 200; ++i) {
        for (const std::size_t n : {20u, 100u, 1000u}) {
            for (const auto& values : {counted(n, 625, 0.2, engine), counted(n, 100'000, 0.2, engine),
                                       printed(test::normal_sample(n, engine, 0.2, 1e-3), 1e-5)}) {
                const auto found = find_repeats(values);
                EXPECT_TRUE(!found || found->p > 1e-6) << n << ": " << found->repeats << " for " << found->expected;
            }
        }
    }
}

TEST(FindRepeats, PredictsHowManyCountsCoincide) {
    std::mt19937_64 engine(4);
    double repeats = 0;
    double expected = 0;
    for (int i = 0; i < 200; ++i) {
        const auto found = find_repeats(counted(300, 10'000, 0.2, engine));
        ASSERT_TRUE(found);
        repeats += static_cast<double>(found->repeats);
        expected += found->expected;
    }
    EXPECT_NEAR(repeats / expected, 1, 0.05);  // some 200 * 175 repeats: a standard error of 0.004
}

TEST(FindRepeats, FindsAQuarterOfTheTrialsCopiedAmongCounts) {
    std::mt19937_64 engine(5);
    std::vector<double> values = counted(400, 1'000'000, 0.2, engine);
    for (std::size_t i = 0; i < 100; ++i) values[i + 200] = values[i];
    EXPECT_LT(find_repeats(values)->p, 1e-6);
}

TEST(FindPeriod, FindsTwoEqualHalvesOfCoarseCounts) {
    std::mt19937_64 engine(6);
    std::vector<double> values = counted(100, 30, 0.2, engine);
    for (std::size_t i = 0; i < 50; ++i) values[i + 50] = values[i];
    EXPECT_EQ(find_period(values, 1e-6), 50u);
}

TEST(FindPeriod, SeesNoneInWhatChanceMakes) {
    std::mt19937_64 engine(7);
    EXPECT_FALSE(find_period(test::normal_sample(1000, engine), 1e-6));
    EXPECT_FALSE(find_period(std::vector<double>(1000, 0.0), 1e-6));  // hits so rare that none was seen
}

}  // namespace
}  // namespace ff::stats

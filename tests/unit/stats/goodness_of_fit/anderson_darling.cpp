#include "stats/goodness_of_fit/anderson_darling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

std::vector<double> sorted_uniform(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> values(n);
    for (double& value : values) value = uniform(engine);
    std::sort(values.begin(), values.end());
    return values;
}

// The critical values that are printed everywhere, to their four digits.
TEST(AndersonDarling, TailHasThePublishedCriticalValues) {
    EXPECT_NEAR(anderson_darling_tail(1.933), 0.10, 5e-5);
    EXPECT_NEAR(anderson_darling_tail(2.492), 0.05, 5e-5);
    EXPECT_NEAR(anderson_darling_tail(3.070), 0.025, 3e-4);
    EXPECT_NEAR(anderson_darling_tail(3.857), 0.01, 3e-4);
}

// The largest part of the sum is half a chi-squared number; the others multiply its tail by sqrt(3) in the limit.
TEST(AndersonDarling, TailIsAccurateForSmallPValues) {
    for (const double z : {50.0, 200.0})
        EXPECT_NEAR(anderson_darling_tail(z) / (std::sqrt(3) * std::erfc(std::sqrt(z))), 1, 0.5 / z);
    EXPECT_EQ(anderson_darling_tail(0), 1);
    EXPECT_EQ(anderson_darling_tail(INFINITY), 0);
}

// By hand: -3 - (ln .25 + ln .25 + 3 (ln .5 + ln .5) + 5 (ln .75 + ln .75)) / 3 with the formula of the definition.
TEST(AndersonDarling, StatisticMatchesItsDefinition) {
    const std::vector<double> u{0.25, 0.5, 0.75};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += (2.0 * static_cast<double>(i) + 1) * (std::log(u[i]) + std::log(1 - u[2 - i]));
    EXPECT_NEAR(anderson_darling(u, 0), -3 - sum / 3, 1e-14);
}

TEST(AndersonDarling, ToleranceNeverIncreasesTheStatisticAndCoversTheDistance) {
    const auto u = sorted_uniform(50, 1);
    double before = anderson_darling(u, 0);
    for (const double tolerance : {0.01, 0.05, 0.1, 0.2}) {
        const double now = anderson_darling(u, tolerance);
        EXPECT_LE(now, before);
        before = now;
    }
    // Uniform numbers that are moved by up to the tolerance have no larger statistic than before.
    auto moved = u;
    for (double& value : moved) value = std::min(1.0, value + 0.1);
    EXPECT_GT(anderson_darling(moved, 0), anderson_darling(u, 0));
    EXPECT_LE(anderson_darling(moved, 0.1), anderson_darling(u, 0));
}

TEST(AndersonDarling, ImpossibleValuesAreInfinitelyFarWithoutATolerance) {
    EXPECT_EQ(anderson_darling(std::vector<double>{0, 0.5}, 0), INFINITY);
    EXPECT_TRUE(std::isfinite(anderson_darling(std::vector<double>{0, 0.5}, 0.01)));
}

// N M - n i over the pooled order a b a b: 1, 0, 1 of 4 values, each squared over i (N - i), over n m.
TEST(AndersonDarling, TwoSampleStatisticMatchesItsDefinition) {
    const std::vector<double> a{1, 3};
    const std::vector<double> b{2, 4};
    EXPECT_NEAR(anderson_darling(a, b, 0), (4.0 / 3 + 0 + 4.0 / 3) / 4, 1e-14);
    EXPECT_EQ(anderson_darling(a, b, 0.5), 0);
    EXPECT_EQ(kolmogorov_distance(a, b), 0.5);
}

TEST(AndersonDarling, TiesBetweenSamplesCountAsOneStep) {
    const std::vector<double> a{1, 1, 2};
    EXPECT_EQ(anderson_darling(a, a, 0), 0);
    EXPECT_EQ(kolmogorov_distance(a, a), 0);
}

TEST(AndersonDarling, KolmogorovsDistanceLooksAtBothSidesOfEachStep) {
    EXPECT_DOUBLE_EQ(kolmogorov_distance(std::vector<double>{0.5}), 0.5);
    EXPECT_DOUBLE_EQ(kolmogorov_distance(std::vector<double>{0.9, 0.95}), 0.9);
}

}  // namespace
}  // namespace ff::stats

#include "stats/variances/variance_interval.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::stats {
namespace {

using test::eight_values;

const ResamplingPlan variance_plan{.key = {.word0 = 1, .word1 = 2}, .replicates = 999};

std::vector<double> laplace_sample(std::size_t n, std::mt19937_64& engine) {
    auto values = test::sample(std::exponential_distribution<double>(), n, engine);
    for (double& value : values) value *= engine() % 2 == 0 ? 1 : -1;
    return values;
}

// from scipy import stats; v = np.var([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3], ddof=1); 7*v/stats.chi2.isf([.025,
// .975], 7)
TEST(VarianceIntervalChi2, AgreesWithScipy) {
    const auto interval = variance_interval_chi2(moments_of(eight_values), 0.95);
    EXPECT_NEAR(interval->low, 2.831491129350904, 1e-12);
    EXPECT_NEAR(interval->high, 26.830479257469044, 1e-11);
    EXPECT_EQ(interval->method, "chi_squared");
}

TEST(VarianceIntervals, AreEmptyWithoutSpread) {
    EXPECT_FALSE(variance_interval_chi2(moments_of(std::array{1.0}), 0.95));
    EXPECT_FALSE(variance_interval_chi2(moments_of(std::array{1.0, 1.0}), 0.95));
    const std::vector<double> equal(20, 0.25);
    EXPECT_FALSE(variance_interval_bootstrap(equal, 0.95, variance_plan));
    EXPECT_FALSE(variance_interval(equal, 0.95, variance_plan));
    EXPECT_FALSE(standard_deviation_interval({}, 0.95, variance_plan));
    EXPECT_FALSE(variance_interval_bootstrap(std::span(eight_values).first(7), 0.95, variance_plan));
}

/// `hits` ones among zeros.
std::vector<double> sparse(std::size_t hits, std::size_t n) {
    std::vector<double> values(n, 0.0);
    std::fill_n(values.begin(), hits, 1.0);
    return values;
}

TEST(VarianceIntervals, AreEmptyWhereFewValuesDiffer) {
    for (const std::size_t hits : {1u, 3u, 6u}) {
        EXPECT_FALSE(variance_interval_bootstrap(sparse(hits, 1000), 0.95, variance_plan)) << hits;
        EXPECT_FALSE(variance_interval(sparse(hits, 1000), 0.95, variance_plan)) << hits;
        EXPECT_FALSE(variance_interval(sparse(1000 - hits, 1000), 0.95, variance_plan)) << hits;
    }
    const auto seven = variance_interval(sparse(7, 1000), 0.95, variance_plan);
    ASSERT_TRUE(seven);
    EXPECT_TRUE(seven->contains(0.007 * 0.993));
    EXPECT_FALSE(variance_interval(sparse(5, 30), 0.95, variance_plan)) << "kurtosis alone would let chi-squared pass";
    EXPECT_FALSE(variance_interval(sparse(1, 5), 0.95, variance_plan));
    EXPECT_TRUE(variance_interval(std::array{20.0, 21.0, 20.0, 22.0, 19.0}, 0.95, variance_plan))
        << "some ties are normal";
}

// Nothing in a resample of as many ones as zeros can make the variance larger. Risks: false alarm 1e-6 of coverage
// below .95; a coverage of .90 is noticed with power .99.
TEST(VarianceInterval, CoversWhereValuesCrowdAtTwoEnds) {
    std::mt19937_64 engine(9);
    std::uint32_t run = 0;
    const auto covered = test::count_events(1500, [&] {
        const auto values = test::sample(std::uniform_int_distribution<int>(0, 1), 100, engine);
        return variance_interval(values, 0.95, {.key = {.word0 = 9, .word1 = run++}, .replicates = 399})
            ->contains(0.25);
    });
    EXPECT_TRUE(test::has_probability_at_least(covered, 1500, 0.95, {.detects = 0.05}));
}

TEST(VarianceIntervalBootstrap, IsTheSameForTheSameKeyAndScalesWithTheData) {
    std::mt19937_64 engine(1);
    const auto values = laplace_sample(50, engine);
    auto scaled = values;
    for (double& value : scaled) value = 0.2 + 0x1p-40 * value;  // variances of 1e-24
    const auto once = variance_interval_bootstrap(values, 0.95, variance_plan);
    const auto again = variance_interval_bootstrap(values, 0.95, variance_plan);
    const auto small = variance_interval_bootstrap(scaled, 0.95, variance_plan);
    EXPECT_EQ(once->low, again->low);
    EXPECT_EQ(once->high, again->high);
    EXPECT_NEAR(small->low / once->low, 0x1p-80, 0x1p-80 * 1e-3);
    EXPECT_NEAR(small->high / once->high, 0x1p-80, 0x1p-80 * 1e-3);
}

TEST(StandardDeviationInterval, NamesTheMethodThatKurtosisCalledFor) {
    std::mt19937_64 engine(5);
    const auto normal = test::normal_sample(200, engine);
    const auto heavy = laplace_sample(200, engine);
    EXPECT_EQ(standard_deviation_interval(normal, 0.95, variance_plan)->method, "chi_squared");
    EXPECT_EQ(standard_deviation_interval(heavy, 0.95, variance_plan)->method, "studentised_bootstrap");
    EXPECT_DOUBLE_EQ(standard_deviation_interval(heavy, 0.95, variance_plan)->high,
                     std::sqrt(variance_interval(heavy, 0.95, variance_plan)->high));
}

// Risks: false alarm 1e-6; a coverage off by .012 is noticed with power .99.
TEST(VarianceIntervalChi2, CoversNormalVariancesAtItsLevel) {
    std::mt19937_64 engine(6);
    const auto hits = test::count_events(
        20'000, [&] { return variance_interval_chi2(moments_of(test::normal_sample(10, engine)), 0.95)->contains(1); });
    EXPECT_TRUE(test::has_probability(hits, 20'000, 0.95, {.detects = 0.012}));
}

// The asymptotic coverage for excess kurtosis 3 is P(|Z| < 1.96 / sqrt(1 + 3/2)) = .785. Risks: 1e-6; .03 at .99.
TEST(VarianceIntervalChi2, FailsForLaplaceDataHoweverMany) {
    std::mt19937_64 engine(7);
    const auto hits = test::count_events(
        10'000, [&] { return variance_interval_chi2(moments_of(laplace_sample(300, engine)), 0.95)->contains(2); });
    EXPECT_TRUE(test::has_probability(hits, 10'000, 0.785, {.detects = 0.031}));
}

// Exponential data have an excess kurtosis of 6, which leaves a quarter of the degrees of freedom. Risks: false alarm
// 1e-6 of coverage below .93; a coverage of .88 is noticed with power .99. Plain chi-squared would cover P(|Z| < 1.96 /
// 2) = .67.
TEST(VarianceInterval, NeedsNoResamplesForLargeSkewedSamples) {
    std::mt19937_64 engine(10);
    const auto draw = [&] {
        return test::sample(std::exponential_distribution<double>(), enough_for_kurtosis, engine);
    };
    EXPECT_EQ(variance_interval(draw(), 0.95, variance_plan)->method, "adjusted_chi_squared");
    const auto covered =
        test::count_events(2100, [&] { return variance_interval(draw(), 0.95, variance_plan)->contains(1); });
    EXPECT_TRUE(test::has_probability_at_least(covered, 2100, 0.93, {.detects = 0.045}));
}

// Risks: false alarm 1e-6 of coverage below .92; a coverage of .86 is noticed with power .99.
TEST(VarianceInterval, CoversLaplaceAndNormalVariances) {
    std::mt19937_64 engine(8);
    std::uint32_t run = 0;
    const auto covers = [&run](const std::vector<double>& values, double truth) {
        return variance_interval(values, 0.95, {.key = {.word0 = 8, .word1 = run++}, .replicates = 399})
            ->contains(truth);
    };
    const auto laplace = test::count_events(1500, [&] { return covers(laplace_sample(100, engine), 2); });
    const auto normal = test::count_events(1500, [&] { return covers(test::normal_sample(100, engine), 1); });
    EXPECT_TRUE(test::has_probability_at_least(laplace, 1500, 0.92, {.detects = 0.06}));
    EXPECT_TRUE(test::has_probability_at_least(normal, 1500, 0.92, {.detects = 0.06}));
}

}  // namespace
}  // namespace ff::stats

#include "stats/variances/variance_interval.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

using test::eight_values;

TEST(Spread, IsChiSquaredWithoutPositiveKurtosis) {
    // Kurtosis below 0 is not used.
    const Moments flat = moments_of(std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
    ASSERT_LT(*flat.excess_kurtosis(), 0);
    EXPECT_EQ(mean_square_of(flat)->freedom, 5);
    // 5 * np.var([1, 2, 3, 4, 5, 6], ddof=1) / stats.chi2.ppf([.975, .025], 5)
    const Interval interval = mean_square_interval(*mean_square_of(flat), 0.95);
    EXPECT_NEAR(interval.low, 17.5 / 12.8325020, 1e-6);
    EXPECT_NEAR(interval.high, 17.5 / 0.8312116, 1e-5);
}

// G2 = stats.kurtosis(x, bias=False) = 3.3925178
TEST(Spread, LosesDegreesOfFreedomToKurtosis) {
    const Moments moments = moments_of(eight_values);
    EXPECT_NEAR(mean_square_of(moments)->freedom, 7 / (1 + *moments.excess_kurtosis() / 2), 1e-12);
    EXPECT_EQ(mean_square_of(moments)->mean_square, *moments.variance());
    EXPECT_EQ(mean_square_of(moments)->n, 8u);
}

TEST(Spread, IsTheMeanSquaredErrorAboutAReference) {
    const auto spread = mean_square_about(eight_values, 3);
    EXPECT_DOUBLE_EQ(spread->mean_square, *moments_of(eight_values, 3).mean_squared_error());
    EXPECT_LT(spread->freedom, 8);
    EXPECT_LT(mean_square_about(std::array{1e-200, -2e-200, 1.5e-200, 1e-200}, 0)->mean_square, 1e-300);
}

TEST(Spread, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(mean_square_of(moments_of(std::array{1.0, 2.0, 3.0})));
    EXPECT_FALSE(mean_square_of(moments_of(std::array{1.0, 1.0, 1.0, 1.0})));
    EXPECT_FALSE(mean_square_about(std::array{1.0, 1.0, 1.0, 1.0}, 1));
    EXPECT_FALSE(mean_square_about(std::array{1.0, 2.0, 3.0}, 1));
    EXPECT_TRUE(mean_square_about(std::array{1.0, 1.0, 1.0, 1.0}, 0));
}

TEST(Spread, HasRatiosThatAgreeWithF) {
    const auto flat = *mean_square_of(moments_of(std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
    // np.sqrt(1 / stats.f.ppf([.975, .025], 5, 5))
    const Interval interval = ratio_interval(flat, flat, 0.95);
    EXPECT_NEAR(interval.low, 0.37407, 1e-5);
    EXPECT_NEAR(interval.high, 2.67328, 1e-5);
}

/// How often intervals at `level` for a variance of 1, and for the ratio of two, miss it.
template <class Draw>
std::array<std::uint64_t, 2> misses(std::uint64_t runs, double level, const Draw& draw) {
    std::array<std::uint64_t, 2> missed{};
    for (std::uint64_t run = 0; run < runs; ++run) {
        const auto a = mean_square_of(moments_of(draw()));
        const auto b = mean_square_of(moments_of(draw()));
        missed[0] += mean_square_interval(*a, level).contains(1) ? 0u : 1u;
        missed[1] += ratio_interval(*a, *b, level).contains(1) ? 0u : 1u;
    }
    return missed;
}

// Risks: false alarm 1e-6 (the rates are no larger than stated); rates larger by the effect are noticed with power .99.
TEST(Spread, MissesTheTruthAsRarelyAsStated) {
    std::mt19937_64 engine(31);
    constexpr std::uint64_t runs = 4000;
    const auto expect_at_most = [&](std::array<std::uint64_t, 2> missed, double rate, double effect) {
        for (const std::uint64_t count : missed)
            EXPECT_TRUE(test::has_probability_at_most(count, runs, rate, {.alpha = 1e-6, .detects = effect})) << count;
    };
    const auto normal = [&] { return test::normal_sample(200, engine); };
    expect_at_most(misses(runs, 0.95, normal), 0.055, 0.03);
    expect_at_most(misses(runs, 0.999, normal), 0.0015, 0.0071);
    const auto uniform = [&] {
        return test::sample(std::uniform_real_distribution<double>(-std::sqrt(3), std::sqrt(3)), 200, engine);
    };
    expect_at_most(misses(runs, 0.999, uniform), 0.0001, 0.004);
    const auto laplace = [&] {
        auto values = test::sample(std::exponential_distribution<double>(std::sqrt(2.0)), 200, engine);
        for (double& value : values) value *= engine() % 2 == 0 ? 1 : -1;
        return values;
    };
    expect_at_most(misses(runs, 0.95, laplace), 0.07, 0.032);
    expect_at_most(misses(runs, 0.999, laplace), 0.005, 0.011);
}

}  // namespace
}  // namespace ff::stats

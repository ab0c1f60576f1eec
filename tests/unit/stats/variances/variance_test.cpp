#include "stats/variances/variance_test.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace ff::stats {
namespace {

constexpr std::array wide_values{1.2, 3.4, 2.2, 5.1, 4.0, 2.9, 3.3, 8.1};
constexpr std::array narrow_values{2.0, 2.5, 2.2, 2.9, 2.4, 2.1, 2.6, 2.3, 2.7};

// from scipy.stats import levene; levene(a, b, center='median'); np.var(a, ddof=1)/np.var(b, ddof=1)
TEST(BrownForsythe, AgreesWithScipy) {
    const auto test = test_variances_brown_forsythe(wide_values, narrow_values);
    EXPECT_NEAR(test->statistic, 4.793308929939559, 1e-12);
    EXPECT_NEAR(test->p, 0.04479515023912076, 1e-13);
    EXPECT_NEAR(test->ratio, 51.02211981566819, 1e-10);
}

TEST(VarianceTests, AreEmptyForTooFewOrEqualValues) {
    const std::array two{1.0, 2.0};
    const std::array equal{1.0, 1.0, 1.0, 1.0};
    EXPECT_FALSE(test_variances_brown_forsythe(wide_values, two));
    EXPECT_FALSE(test_variances_brown_forsythe(equal, equal));
}

/// Rejections at .05 among `runs` pairs of exponential samples, of which the first is scaled.
struct Rejections {
    std::uint64_t fisher = 0, brown_forsythe = 0;
};

Rejections rejections_of_pairs(int runs, double scale, std::mt19937_64& engine) {
    Rejections count;
    for (int run = 0; run < runs; ++run) {
        auto x = test::sample(std::exponential_distribution<double>(), 50, engine);
        const auto y = test::sample(std::exponential_distribution<double>(), 50, engine);
        for (double& value : x) value *= scale;
        const double ratio = *moments_of(x).variance() / *moments_of(y).variance();
        count.fisher += 2 * fisher_tail(std::max(ratio, 1 / ratio), 49, 49) < 0.05 ? 1u : 0u;
        count.brown_forsythe += test_variances_brown_forsythe(x, y)->p < 0.05 ? 1u : 0u;
    }
    return count;
}

// Exponential data, excess kurtosis 6: F rejects equal variances one time in three. Risks: 1e-6; .05 at power .99.
TEST(VarianceTests, KeepTheirLevelUnderTheKurtosisThatBreaksF) {
    std::mt19937_64 engine(3);
    const Rejections level = rejections_of_pairs(1200, 1, engine);
    EXPECT_TRUE(test::has_probability_at_most(level.brown_forsythe, 1200, 0.06, {.detects = 0.05}));
    EXPECT_FALSE(test::has_probability_at_most(level.fisher, 1200, 0.08, {.detects = 0.06}));
}

TEST(VarianceTests, FindATrebledStandardDeviation) {
    std::mt19937_64 engine(4);
    const Rejections power = rejections_of_pairs(200, 3, engine);
    EXPECT_GT(power.brown_forsythe, 180u);
}

}  // namespace
}  // namespace ff::stats

#include "stats/goodness_of_fit/anderson_darling.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/basics/moments.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::stats {
namespace {

using test::eight_values;

// from scipy import stats; stats.anderson([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3], 'norm').statistic
TEST(AndersonDarling, AgreesWithScipy) {
    EXPECT_NEAR(test_normality(eight_values)->statistic, 0.6070864431888072, 1e-12);
}

// Stephens' critical values of the adjusted statistic: .631 at .10, .752 at .05, .873 at .025, 1.035 at .01
TEST(AndersonDarling, PAgreesWithStephensCriticalValues) {
    const auto p_at = [](double adjusted) {
        return std::exp(1.2937 - 5.709 * adjusted + 0.0186 * adjusted * adjusted);
    };
    EXPECT_NEAR(p_at(0.752), 0.05, 0.001);  // the published points that the fit must pass through
    EXPECT_NEAR(p_at(1.035), 0.01, 0.0005);
    const auto test = test_normality(eight_values);
    EXPECT_NEAR(test->adjusted, test->statistic * (1 + 0.75 / 8 + 2.25 / 64), 1e-14);
    EXPECT_NEAR(test->p, p_at(test->adjusted), 1e-14);
}

TEST(AndersonDarling, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(test_normality(std::span(eight_values).first(7)));
    EXPECT_FALSE(test_normality(std::vector<double>(20, 0.2)));
}

TEST(AndersonDarling, IsInvariantUnderShiftAndScale) {
    std::array<double, 8> moved{};
    std::transform(eight_values.begin(), eight_values.end(), moved.begin(), [](double x) { return 1e6 + 1e-3 * x; });
    EXPECT_NEAR(test_normality(moved)->statistic, 0.6070864431888072, 1e-5);
}

TEST(AndersonDarling, StaysFiniteForAnOutlierFarBeyondTheNormalTail) {
    std::mt19937_64 engine(1);
    auto values = test::normal_sample(5000, engine);
    values.push_back(1e6);
    const auto test = test_normality(values);
    EXPECT_TRUE(std::isfinite(test->statistic));
    EXPECT_LT(test->p, 1e-20);
    EXPECT_GT(test->p, 0);
}

// Risks: 1e-6; a level off by .017 at .05 is noticed with power .99. (Stephens' fit itself is good to some .002.)
TEST(AndersonDarling, RejectsNormalDataAtItsLevel) {
    std::mt19937_64 engine(2);
    for (const std::size_t n : {10u, 100u}) {
        const auto rejected =
            test::count_events(10'000, [&] { return test_normality(test::normal_sample(n, engine, 7, 3))->p < 0.05; });
        EXPECT_TRUE(test::has_probability(rejected, 10'000, 0.05, {.detects = 0.017}));
    }
}

TEST(AndersonDarling, FindsExponentialData) {
    std::mt19937_64 engine(3);
    const auto rejected = test::count_events(200, [&] {
        return test_normality(test::sample(std::exponential_distribution<double>(), 100, engine))->p < 0.01;
    });
    EXPECT_GT(rejected, 190u);
}

// Hit counts with sigma = 4 hits and 400 trials: rejected for being discrete alone, cured by half a hit of jitter.
// Risks: 1e-6; a level off by .059 is noticed with power .99.
TEST(JitterLattice, MakesCountsTestable) {
    std::mt19937_64 engine(4);
    std::uint32_t run = 0;
    std::uint64_t raw = 0;
    std::uint64_t jittered = 0;
    constexpr std::uint64_t runs = 1000;
    for (std::uint64_t i = 0; i < runs; ++i) {
        auto counts = test::normal_sample(400, engine, 100, 4);
        for (double& count : counts) count = std::round(count) / 625;
        raw += test_normality(counts)->p < 0.05 ? 1u : 0u;
        jittered += test_normality(jitter_lattice(counts, 1.0 / 625, {.word0 = 4, .word1 = run++}))->p < 0.05 ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(jittered, runs, 0.05, {.detects = 0.059}));
    EXPECT_LT(binomial_upper_p({raw, runs}, 0.08), 1e-6);
}

TEST(JitterLattice, MovesByAtMostHalfASpacingAndIsSeeded) {
    const std::vector<double> zeros(1000, 0.0);
    const auto jittered = jitter_lattice(zeros, 0.5, {.word0 = 1});
    const auto [low, high] = std::minmax_element(jittered.begin(), jittered.end());
    EXPECT_GE(*low, -0.25);
    EXPECT_LT(*high, 0.25);
    EXPECT_GT(*high - *low, 0.45);
    EXPECT_EQ(jittered, jitter_lattice(zeros, 0.5, {.word0 = 1}));
    EXPECT_NE(jittered, jitter_lattice(zeros, 0.5, {.word0 = 2}));
}

}  // namespace
}  // namespace ff::stats

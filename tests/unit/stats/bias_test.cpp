#include "stats/bias_test.hpp"

#include "stats/power.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff::stats {
namespace {

using test::eight_values;

// from scipy import stats; stats.ttest_1samp([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3], 3)
TEST(BiasTest, AgreesWithScipy) {
    const auto test = test_bias(moments_of(eight_values, 3));
    EXPECT_NEAR(test->t, 1.2780595680067588, 1e-13);
    EXPECT_NEAR(test->p, 0.24197449074865127, 1e-13);
    EXPECT_EQ(test->freedom, 7);
    EXPECT_NEAR(test->bias, 1.15, 1e-14);
}

TEST(BiasTest, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(test_bias(moments_of(std::array{1.0})));
    EXPECT_FALSE(test_bias(moments_of(std::array{1.0, 1.0, 1.0}, 2)));
    EXPECT_FALSE(test_equivalence(moments_of(std::array{1.0, 1.0}), 1, 0.05));
}

TEST(BiasTest, PValueIsNotZeroFarInTheTail) {
    std::mt19937_64 engine(1);
    const auto test = test_bias(moments_of(test::normal_sample(400, engine, 1), 0));  // t near 20
    EXPECT_GT(test->p, 0);
    EXPECT_LT(test->p, 1e-40);
}

// x = np.array([...]); stats.t.sf((2.5 - abs(x.mean() - 3))/stats.sem(x), 7); stats.t.interval(.9, 7, x.mean() - 3,
// stats.sem(x))
TEST(EquivalenceTest, AgreesWithScipy) {
    const auto test = test_equivalence(moments_of(eight_values, 3), 2.5, 0.05);
    EXPECT_NEAR(test->p, 0.08860748498580198, 1e-13);
    EXPECT_NEAR(test->interval.low, -0.5547447946823611, 1e-13);
    EXPECT_NEAR(test->interval.high, 2.854744794682361, 1e-13);
    EXPECT_FALSE(test->equivalent);
    EXPECT_FALSE(test->different);
    EXPECT_TRUE(test_equivalence(moments_of(eight_values, 3), 3, 0.05)->equivalent);
    EXPECT_TRUE(test_equivalence(moments_of(eight_values, 0), 1, 0.05)->different);
}

// Risks: false alarm 1e-6; an error rate off by .006 at .01, .03 at the power, is noticed with power .99.
TEST(BiasTest, RejectsTheTruthAtAlphaAndTheMinimumDetectableBiasAtItsPower) {
    constexpr Risks risks{.alpha = 0.01, .power = 0.9};
    const double bias = minimum_detectable_bias(1, 12, risks);
    std::mt19937_64 engine(2);
    const auto rejects = [&](double shift) {
        return test_bias(moments_of(test::normal_sample(12, engine, shift), 0))->p < risks.alpha;
    };
    const auto false_alarms = test::count_events(20'000, [&] { return rejects(0); });
    const auto detections = test::count_events(20'000, [&] { return rejects(bias); });
    EXPECT_TRUE(test::has_probability(false_alarms, 20'000, risks.alpha, {.detects = 0.006}));
    EXPECT_TRUE(test::has_probability(detections, 20'000, risks.power, {.detects = 0.03}));
}

// At the margin itself two one-sided tests pass at most alpha. Risks as above.
TEST(EquivalenceTest, PassesABiasAtTheMarginAtAlphaAndNoBiasAtItsPower) {
    constexpr Risks risks{.alpha = 0.05, .power = 0.8};
    const double margin = equivalence_margin(1, 20, risks);
    std::mt19937_64 engine(3);
    const auto passes = [&](double shift) {
        return test_equivalence(moments_of(test::normal_sample(20, engine, shift), 0), margin, risks.alpha)->equivalent;
    };
    const auto wrong = test::count_events(20'000, [&] { return passes(margin); });
    const auto right = test::count_events(20'000, [&] { return passes(0); });
    EXPECT_TRUE(test::has_probability(wrong, 20'000, risks.alpha, {.detects = 0.012}));
    EXPECT_TRUE(test::has_probability(right, 20'000, risks.power, {.detects = 0.03}));
}

}  // namespace
}  // namespace ff::stats

// The statistical assertions that other tests rely on are tested here: each passes on sound data, and fails both on
// broken data and where the data could not have shown a fault.

#include "tests/support/statistical_assertions.hpp"

#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ff::test {
namespace {

TEST(UnbiasedAssertion, PassesSoundReplicates) {
    std::mt19937_64 engine(1);
    EXPECT_TRUE(unbiased(normal_sample(400, engine, 0.2, 0.01), 0.2, {.alpha = 1e-7, .detects = 0.005}));
}

TEST(UnbiasedAssertion, FailsOnBias) {
    std::mt19937_64 engine(1);
    const auto result = unbiased(normal_sample(400, engine, 0.206, 0.01), 0.2, {.alpha = 1e-7, .detects = 0.005});
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find("< alpha"), std::string::npos) << result.message();
}

TEST(UnbiasedAssertion, FailsWhenTooNoisyToNotice) {
    std::mt19937_64 engine(1);
    const auto result = unbiased(normal_sample(400, engine, 0.2, 0.1), 0.2, {.alpha = 1e-7, .detects = 0.005});
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find("more trials"), std::string::npos) << result.message();
}

TEST(UnbiasedAssertion, FailsWithoutSpread) {
    EXPECT_FALSE(unbiased(std::vector<double>(100, 0.2), 0.2, {.detects = 1}));
    EXPECT_FALSE(unbiased(std::vector<double>{0.2}, 0.2, {.detects = 1}));
    EXPECT_FALSE(unbiased(std::vector<double>{}, 0.2, {.detects = 1}));
}

TEST(UnbiasedAssertion, NoticesThePromisedEffectWithThePromisedPower) {
    std::mt19937_64 engine(2);
    constexpr StatisticalRisk risk{.alpha = 1e-3, .detects = 0.75, .power = 0.9};
    // 60 standard normal values suffice (minimum detectable bias .61), so sound data pass and biased ones do not.
    const auto caught = count_events(300, [&] { return !unbiased(normal_sample(60, engine, risk.detects), 0, risk); });
    const auto passed = count_events(300, [&] { return bool(unbiased(normal_sample(60, engine), 0, risk)); });
    EXPECT_GT(caught, 280u);  // power .98: scipy nct.sf(t.isf(.0005, 59), 59, .75*60**.5)
    EXPECT_GT(passed, 280u);  // a scatter of s above 1.2 is called too noisy, and may be
}

TEST(ProbabilityAssertion, PassesAndFailsOnBothSides) {
    constexpr StatisticalRisk risk{.alpha = 1e-6, .detects = 0.02};
    EXPECT_TRUE(has_probability(9500, 10'000, 0.95, risk));
    EXPECT_FALSE(has_probability(9300, 10'000, 0.95, risk));
    EXPECT_FALSE(has_probability(9650, 10'000, 0.95, risk));
    EXPECT_TRUE(has_probability_at_least(9650, 10'000, 0.95, risk));
    EXPECT_FALSE(has_probability_at_least(9300, 10'000, 0.95, risk));
    EXPECT_TRUE(has_probability_at_most(9300, 10'000, 0.95, risk));
    EXPECT_FALSE(has_probability_at_most(9650, 10'000, 0.95, risk));
}

TEST(ProbabilityAssertion, FailsWithTooFewTrials) {
    constexpr StatisticalRisk risk{.alpha = 1e-6, .detects = 0.02};
    EXPECT_FALSE(has_probability(95, 100, 0.95, risk));
    EXPECT_FALSE(has_probability_at_least(95, 100, 0.95, risk));
    EXPECT_FALSE(has_probability_at_most(95, 100, 0.95, risk));
}

// python3 -c "from scipy.stats import binom; from scipy.optimize import brentq; c = int(binom.isf(1e-6, 100, .05)) + 1;
// print(brentq(lambda p: binom.sf(c - 1, 100, p) - .99, .05, .9) - .05)" prints 0.2365.
TEST(ProbabilityAssertion, PromisesNoMorePowerThanItHas) {
    const auto promises = [](double detects) { return StatisticalRisk{.alpha = 1e-6, .detects = detects}; };
    EXPECT_TRUE(has_probability_at_most(5, 100, 0.05, promises(0.2366)));
    EXPECT_FALSE(has_probability_at_most(5, 100, 0.05, promises(0.2364)));
    EXPECT_TRUE(has_probability_at_least(95, 100, 0.95, promises(0.2366)));
    EXPECT_FALSE(has_probability_at_least(95, 100, 0.95, promises(0.2364)));
    EXPECT_FALSE(has_probability(5, 100, 0.05, promises(0.2364))) << "upwards alone";
    EXPECT_FALSE(has_probability_at_most(3, 3, 0.05, promises(0.9))) << "no three of three are rare enough";
}

}  // namespace
}  // namespace ff::test

#include "stats/error_rates/power.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

constexpr double family_alpha = 1e-4;
constexpr double each_alpha = family_alpha / 30;

// T = 100 trials, 30 pairs, family alpha 1e-4, power .9: .63 sigma for the test. .6274 is brentq of the power by
// SciPy's noncentral t: t = stats.t.isf(a/2, n-1); d = b*np.sqrt(n)/s; nct.sf(t, n-1, d) + nct.cdf(-t, n-1, d)
TEST(MinimumDetectableBias, IsPointSixThreeSigmaForAHundredTrialsAndThirtyPairs) {
    const double exact = minimum_detectable_bias(1, 100, {.alpha = each_alpha, .power = 0.9});
    const double approximate = (student_critical(99, each_alpha / 2) + normal_critical(0.1)) / 10;
    EXPECT_NEAR(exact, 0.6273963075678419, 1e-7);
    EXPECT_NEAR(approximate, 0.6209956070622736, 1e-9);
    EXPECT_NEAR(minimum_detectable_bias(1.23e-3, 100, {.alpha = each_alpha, .power = 0.9}), 7.7e-4, 5e-6);
    EXPECT_NEAR(minimum_detectable_bias(1, 100, {.alpha = sidak_level(family_alpha, 30), .power = 0.9}), exact, 1e-5);
}

// quad and brentq of the integral over s; the usual approximation gives .640 and .769.
TEST(EquivalenceMargin, IsPointSixFiveSigmaForOnePairAndPointSevenEightForThirty) {
    constexpr Risks risks{.alpha = each_alpha, .power = 0.9};
    EXPECT_NEAR(equivalence_margin(1, 100, risks), 0.6482823252951708, 1e-7);
    EXPECT_NEAR(equivalence_margin(1, 100, risks, 30), 0.7847191808483435, 1e-7);
    EXPECT_NEAR(equivalence_margin(1, 100, {.alpha = 0.05, .power = 0.9}, 30), 0.46118619212310824, 1e-7);
    EXPECT_NEAR((student_critical(99, each_alpha) + normal_critical(0.05)) / 10, 0.6402857496603763, 1e-9);
}

// M = m*sqrt(n)/s; D = b*sqrt(n)/s; nu = n-1; t = stats.t.isf(a, nu)
// quad(lambda u: (norm.cdf(M-D-t*u) - norm.cdf(-M-D+t*u)) * chi2.pdf(nu*u*u, nu)*2*nu*u, 0, M/t)
TEST(EquivalencePower, AgreesWithScipysIntegral) {
    EXPECT_NEAR(equivalence_power(1, 0, 1, 20, 0.05), 0.9922057272686262, 1e-9);
    EXPECT_NEAR(equivalence_power(0.5, 0.1, 1, 50, 0.05), 0.8681534580128467, 1e-9);
    EXPECT_NEAR(equivalence_power(0.3, 0, 1, 20, 0.05), 0.008390208274493592, 1e-9);
}

TEST(TrialsForEquivalence, AreTheFewestThatReachThePower) {
    constexpr Risks risks{.alpha = 0.05, .power = 0.9};
    for (const std::size_t pairs : {1u, 30u}) {
        const std::size_t trials = trials_for_equivalence(0.1, 1, risks, pairs);
        EXPECT_LE(equivalence_margin(1, trials, risks, pairs), 0.1);
        EXPECT_GT(equivalence_margin(1, trials - 1, risks, pairs), 0.1);
    }
}

TEST(MinimumDetectableBias, IsFiniteForTwoTrialsAndZeroWithoutSpread) {
    EXPECT_TRUE(std::isfinite(minimum_detectable_bias(1, 2, {.alpha = 1e-6, .power = 0.99})));
    EXPECT_GT(minimum_detectable_bias(1, 2, {.alpha = 1e-6, .power = 0.99}), 1e4);
    EXPECT_EQ(minimum_detectable_bias(0, 10, {}), 0);
}

TEST(MinimumDetectableBias, ShrinksAsTheRootOfManyTrials) {
    constexpr Risks risks{.alpha = 1e-4, .power = 0.9};
    EXPECT_NEAR(minimum_detectable_bias(1, 40'000'000, risks) / minimum_detectable_bias(1, 10'000'000, risks), 0.5,
                1e-5);
}

// A difference is found in about 360 of 400 pairs of skewed samples whose means differ by the detectable difference.
// Fewer than 335, five standard deviations less, would have a probability below 1e-6.
TEST(DetectableDifference, IsFoundWithThePowerWhereTrialsAreSkewed) {
    std::mt19937_64 random(1);
    std::lognormal_distribution<double> skewed(0, 0.5);
    constexpr Risks risks{.alpha = 1e-3, .power = 0.9};
    int found = 0;
    for (int repetition = 0; repetition < 400; ++repetition) {
        std::vector<double> first(200), second(200);
        for (double& x : first) x = skewed(random);
        for (double& x : second) x = skewed(random);
        const double apart = detectable_difference(*difference_of_means(first, second), risks);
        ASSERT_TRUE(std::isfinite(apart));
        for (double& x : second) x += repetition % 2 == 0 ? apart : -apart;
        found += test_mean(*difference_of_means(first, second)).p < risks.alpha ? 1 : 0;
    }
    EXPECT_GT(found, 335);
}

TEST(DetectableDifference, IsInfiniteWhereTrialsAreTooFew) {
    const std::vector<double> few{0, 0, 0, 1}, more{0, 0, 1, 9};
    EXPECT_TRUE(std::isinf(detectable_difference(*difference_of_means(few, more), {.alpha = 1e-6, .power = 0.9})));
}

}  // namespace
}  // namespace ff::stats

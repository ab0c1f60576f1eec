#include "stats/means/mean_test.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace ff::stats {
namespace {

using test::eight_values;

constexpr std::array first_sample{2.1, 3.4, 1.9, 5.6};
constexpr std::array second_sample{4.4, 2.8, 9.7, 3.3, 8.1};

std::vector<double> exponential_quantiles(std::size_t n) {
    std::vector<double> values;  // so that nothing is left to chance
    for (std::size_t i = 0; i < n; ++i)
        values.push_back(-std::log1p(-(static_cast<double>(i) + 0.5) / static_cast<double>(n)));
    return values;
}

/// Distances of both limits from the mean, in standard errors.
struct Reach {
    double below = 0;
    double above = 0;
};
Reach reach(const std::vector<double>& values, double tail) {
    const auto mean = *mean_evidence(values, 0);
    const Interval interval = interval_of(mean, 1 - 2 * tail);
    return {(mean.difference - interval.low) / mean.standard_error,
            (interval.high - mean.difference) / mean.standard_error};
}

// from scipy import stats; stats.ttest_1samp([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3], 3); stats.t.interval(.9, 7,
// x.mean() - 3, stats.sem(x))
TEST(MeanTest, IsStudentsTForUnskewedValues) {
    const auto mean = *mean_evidence(eight_values, 3, not_skewed);
    EXPECT_NEAR(mean.t(), 1.2780595680067588, 1e-13);
    EXPECT_EQ(mean.freedom, 7);
    EXPECT_NEAR(mean.difference, 1.15, 1e-14);
    EXPECT_NEAR(test_mean(mean).p, 0.24197449074865127, 1e-12);
    EXPECT_EQ(test_mean(mean).p, test_mean(mean).student_p);
    EXPECT_NEAR(interval_of(mean, 0.9).low, -0.5547447946823611, 1e-12);
    EXPECT_NEAR(interval_of(mean, 0.9).high, 2.854744794682361, 1e-12);
}

TEST(MeanTest, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(mean_evidence(std::array{1.0, 2.0}, 0));
    EXPECT_FALSE(mean_evidence(std::array{1.0, 1.0, 1.0}, 2));
    EXPECT_FALSE(mean_interval(exponential_quantiles(4), 0, 0.95));
    EXPECT_FALSE(difference_of_means(first_sample, std::array{1.0}));
    EXPECT_FALSE(difference_of_means(std::array{3.0, 3.0, 3.0}, std::array{3.0, 3.0, 3.0}));
}

TEST(MeanTest, PValueIsNotZeroFarInTheTail) {
    std::mt19937_64 engine(1);
    const auto test = test_mean(*mean_evidence(test::normal_sample(400, engine, 1), 0));  // t near 20
    EXPECT_GT(test.student_p, 0);
    EXPECT_LT(test.student_p, 1e-40);
    EXPECT_GT(test.p, test.student_p);
    EXPECT_LT(test.p, 1e-20);
}

// The interval of level 1 - p has an end at 0.
TEST(MeanTest, PValueAndIntervalAgree) {
    for (const double reference : {0.6, 0.8, 1.1, 1.4}) {
        const auto mean = *mean_evidence(exponential_quantiles(60), reference);
        const double p = test_mean(mean).p;
        EXPECT_TRUE(interval_of(mean, 1 - p * 0.999).contains(0)) << reference;
        EXPECT_FALSE(interval_of(mean, 1 - p * 1.001).contains(0)) << reference;
    }
}

TEST(MeanTest, IsNearlyStudentsTForManySymmetricValues) {
    std::mt19937_64 engine(1);
    const auto found = reach(test::normal_sample(100'000, engine), 5e-5);
    const double t = student_critical(99'999, 5e-5);
    EXPECT_GE(found.below, t);
    EXPECT_GE(found.above, t);
    // 2.7 standard errors of the skewness, and one of its own: 0.03 z^2 / (3 sqrt n).
    EXPECT_LT(std::max(found.below, found.above), 1.003 * t);
}

TEST(MeanTest, ReachesFurtherTowardsALongTail) {
    for (const double sign : {1.0, -1.0}) {
        std::vector<double> values = exponential_quantiles(200);
        for (double& value : values) value *= sign;
        const auto found = reach(values, 5e-5);
        EXPECT_GT(sign > 0 ? found.above : found.below, 1.2 * (sign > 0 ? found.below : found.above));
    }
}

TEST(MeanTest, DoesNotDependOnUnitAndOrigin) {
    std::vector<double> values = exponential_quantiles(50);
    const auto found = reach(values, 1e-3);
    for (double& value : values) value = 1e-60 * (value + 0.25);
    const auto scaled = reach(values, 1e-3);
    EXPECT_NEAR(scaled.above, found.above, 1e-9 * found.above);
    EXPECT_NEAR(scaled.below, found.below, 1e-9 * found.below);
}

TEST(MeanTest, HasNoLimitTowardsTheTailOfFewSkewedValues) {
    EXPECT_TRUE(std::isinf(reach(exponential_quantiles(40), 5e-6).above));
    EXPECT_FALSE(std::isinf(reach(exponential_quantiles(40), 5e-6).below));
    EXPECT_FALSE(std::isinf(reach(exponential_quantiles(40), 0.05).above));
    EXPECT_FALSE(std::isinf(reach(exponential_quantiles(4000), 5e-6).above));
}

// Or an interval at a higher level would lie within one at a lower level, and a p-value would have no meaning.
TEST(MeanTest, ReachesFurtherForSmallerTailsAndMoreSkewness) {
    for (const double error : {0.01, 0.05, 0.2, 0.6}) {
        for (const double freedom : {4.0, 30.0, 1e6}) {
            double reached_before = 0;  // with less skewness
            for (double skewness = -0.5; skewness < 2; skewness += 0.01) {
                double reached = 0;  // with a larger tail
                for (double tail = 0.2; tail > 1e-12; tail /= 1.2) {
                    const double reach = gate::skewed_reach({.value = skewness, .error = error, .insignificant = 3}, 1,
                                                            student_critical(freedom, tail), normal_critical(tail));
                    ASSERT_GE(reach, reached * (1 - 1e-12)) << skewness << ' ' << error << ' ' << tail;
                    reached = reach;
                }
                ASSERT_GE(reached, reached_before * (1 - 1e-12)) << skewness << ' ' << error;
                reached_before = reached;
            }
        }
    }
}

TEST(MeanTest, HasNoLimitsForVeryFewValues) {
    std::mt19937_64 engine(2);
    const auto found = reach(test::normal_sample(8, engine), 5e-4);
    EXPECT_TRUE(std::isinf(found.below) && std::isinf(found.above));
}

TEST(MeanTest, TreatsMeansOfManySmallPartsAsHardlySkewed) {
    const auto values = exponential_quantiles(8);
    const auto unknown = mean_evidence(values, 0);
    const auto known = mean_evidence(values, 0, {.largest_part = 1e-4, .unmet = {}});
    EXPECT_TRUE(std::isinf(interval_of(*unknown, 0.999).high));
    const double t = student_critical(7, 0.0005);
    EXPECT_NEAR(interval_of(*known, 0.999).high, known->difference + t * known->standard_error, 1e-2);
}

// A jump of 2 that none of 1000 evaluations has met, at a tenth of the tail of 0.025: python: 2 * (1 - 0.0025 ** 1e-3).
TEST(MeanTest, AllowsForJumpsThatNoEvaluationHasMet) {
    constexpr double missed = 0.011947103032699191;
    const auto seen = mean_evidence(eight_values, 3, not_skewed);
    const auto jumping =
        mean_evidence(eight_values, 3, {.largest_part = no_part, .unmet = {.largest = 2, .evaluations = 1000}});
    EXPECT_NEAR(interval_of(*jumping, 0.95).low, interval_of(*seen, 0.955).low - missed, 1e-12);
    EXPECT_NEAR(interval_of(*jumping, 0.95).high, interval_of(*seen, 0.955).high + missed, 1e-12);
    EXPECT_GT(test_mean(*jumping).p, test_mean(*seen).p);
    EXPECT_EQ(test_mean(*jumping).student_p, test_mean(*seen).student_p);
}

TEST(MeanTest, AllowsForTheRoundingOfValuesAndReference) {
    const auto exact = mean_evidence(eight_values, 3, not_skewed);
    const auto rounded = mean_evidence(eight_values, 3, {.largest_part = no_part, .unmet = {}, .rounding = 0.25});
    EXPECT_NEAR(interval_of(*rounded, 0.95).low, interval_of(*exact, 0.95).low - 0.25, 1e-12);
    EXPECT_NEAR(interval_of(*rounded, 0.95).high, interval_of(*exact, 0.95).high + 0.25, 1e-12);
    EXPECT_GT(test_mean(*rounded).p, test_mean(*exact).p);
}

// Trials that agree to nine digits are far from the reference, and none has met what one in 500 evaluations may meet.
TEST(MeanTest, FindsNoDifferenceThatRareEvaluationsMayExplain) {
    std::vector<double> values;
    for (int i = 0; i < 30; ++i) values.push_back(0.5 + 1e-9 * (i % 7));
    const auto judged = [&](double evaluations) {
        return test_mean(*mean_evidence(values, 0.501, {.unmet = {.largest = 1, .evaluations = evaluations}})).p;
    };
    EXPECT_NEAR(judged(300), 1, 1e-9);
    EXPECT_LT(judged(30'000), 1e-6);
}

// Python: va, vb = variance(a) / 4, variance(b) / 5 (statistics); t = (mean(b) - mean(a)) / sqrt(va + vb);
// df = (va + vb)**2 / (va**2 / 3 + vb**2 / 4); p = 1 - 2 * (Simpson's rule over Student's density from 0 to t, 200000
// steps)
TEST(MeanDifference, AgreesWithWelchsFormulas) {
    const auto mean = *difference_of_means(first_sample, second_sample);
    EXPECT_NEAR(mean.difference, 2.41, 1e-14);
    EXPECT_NEAR(mean.t(), 1.4932503657627956, 1e-13);
    EXPECT_NEAR(mean.freedom, 6.406989976675685, 1e-12);
    EXPECT_NEAR(test_mean(mean).student_p, 0.18289368648894733, 1e-12);
}

TEST(MeanDifference, KeepsItsDigitsFarFromZero) {
    std::array shifted = first_sample;
    for (double& value : shifted) value = 1e6 + value * 0x1p-20;
    std::array other = second_sample;
    for (double& value : other) value = 1e6 + value * 0x1p-20;
    const auto near = *difference_of_means(first_sample, second_sample);
    const auto far = *difference_of_means(shifted, other);
    EXPECT_NEAR(far.t(), near.t(), 1e-3);  // spacing of doubles near 10^6: 1e-10, in differences of 1e-6
}

TEST(MeanDifference, AcceptsAConstantSample) {
    const auto mean = *difference_of_means(std::array{3.0, 3.0, 3.0}, second_sample);
    EXPECT_NEAR(mean.freedom, 4, 1e-12);
    EXPECT_NEAR(mean.difference, 2.66, 1e-14);
}

TEST(MeanDifference, IsNotSkewedForEquallySkewedSamples) {
    const auto values = exponential_quantiles(60);
    const auto mean = *difference_of_means(values, values);
    EXPECT_NEAR(mean.skewness.value, 0, 1e-12);
    EXPECT_GT(mean.skewness.error, 0);
}

TEST(UnseenValue, GivesTheWantedMeanAndIsMissedWithTheTailProbability) {
    const auto unseen = unseen_value(1, 2, 60, 1e-3);
    const double share = 1 / unseen.one_in;
    EXPECT_NEAR((1 - share) * 1 + share * unseen.value, 2, 1e-12);
    EXPECT_NEAR(std::pow(1 - share, 60), 1e-3, 1e-15);
}

// Risks: false alarm 1e-6; an error rate off by .006 at .01, .03 at the power, is noticed with power .99.
TEST(MeanTest, RejectsTheTruthAtAlphaAndTheMinimumDetectableBiasAtItsPower) {
    constexpr Risks risks{.alpha = 0.01, .power = 0.9};
    const double bias = minimum_detectable_bias(1, 12, risks);
    std::mt19937_64 engine(2);
    const auto rejects = [&](double shift) {
        return test_mean(*mean_evidence(test::normal_sample(12, engine, shift), 0, not_skewed)).p < risks.alpha;
    };
    const auto false_alarms = test::count_events(20'000, [&] { return rejects(0); });
    const auto detections = test::count_events(20'000, [&] { return rejects(bias); });
    EXPECT_TRUE(test::has_probability(false_alarms, 20'000, risks.alpha, {.detects = 0.006}));
    EXPECT_TRUE(test::has_probability(detections, 20'000, risks.power, {.detects = 0.03}));
}

/// Studies of 30 means of a law with mean `truth`.
struct Studies {
    std::function<double(std::mt19937_64&)> law;
    double truth = 0;
    std::size_t trials = 0;

    /// How many of them find a difference at a family-wise 5 %.
    [[nodiscard]] std::uint64_t that_differ(std::uint64_t studies, std::uint64_t seed) const {
        std::mt19937_64 engine(seed);
        const double alpha = sidak_level(0.05, 30);
        return test::count_events(studies, [&] {
            bool differs = false;
            std::vector<double> values(trials);
            for (int mean = 0; mean < 30; ++mean) {
                for (double& value : values) value = law(engine);
                const auto evidence = mean_evidence(values, truth);
                differs = differs || !interval_of(*evidence, 1 - alpha).contains(0);
            }
            return differs;
        });
    }
};

double log_normal(std::mt19937_64& engine) {
    return std::lognormal_distribution<double>(0, 0.7)(engine);
}

// Student's t calls 48, 38, 24 and 13 % of such studies biased. Risks: false alarm 1e-6; .16 is noticed with power .99.
TEST(MeanTest, CallsAtMostFivePercentOfSkewedStudiesBiased) {
    constexpr std::uint64_t studies = 400;
    for (const std::size_t trials : {10u, 30u, 50u, 200u}) {
        const Studies skewed{log_normal, std::exp(0.245), trials};
        EXPECT_TRUE(test::has_probability_at_most(skewed.that_differ(studies, trials), studies, 0.05,
                                                  {.alpha = 1e-6, .detects = 0.11}))
            << trials << " trials";
    }
}

// The same assertion on the rule without its caution.
TEST(MeanTest, CallsSkewedStudiesBiasedIfDoneByStudentsT) {
    std::mt19937_64 engine(3);
    const double alpha = sidak_level(0.05, 30);
    std::vector<double> values(30);
    const auto biased = test::count_events(200, [&] {
        bool differs = false;
        for (int mean = 0; mean < 30; ++mean) {
            for (double& value : values) value = log_normal(engine);
            const auto evidence = mean_evidence(values, std::exp(0.245), not_skewed);
            differs = differs || !interval_of(*evidence, 1 - alpha).contains(0);
        }
        return differs;
    });
    EXPECT_GT(biased, 40u);
}

// At 8 standard errors Student's t finds everything. Risks: 1e-6; a power lower by .06 is noticed with power .99.
TEST(MeanTest, FindsABiasOfEightStandardErrorsOfNormalValues) {
    struct Case {
        std::size_t trials;
        double power;
    };
    for (const Case& each : {Case{30, 0.8}, Case{50, 0.95}, Case{100, 0.95}}) {
        std::mt19937_64 engine(each.trials);
        const double bias = 8 / std::sqrt(static_cast<double>(each.trials));
        const auto found = test::count_events(3000, [&] {
            const auto mean = mean_evidence(test::normal_sample(each.trials, engine, bias), 0);
            return interval_of(*mean, 1 - sidak_level(0.05, 30)).low > 0;
        });
        EXPECT_TRUE(test::has_probability_at_least(found, 3000, each.power, {.alpha = 1e-6, .detects = 0.06}))
            << each.trials;
    }
}

}  // namespace
}  // namespace ff::stats

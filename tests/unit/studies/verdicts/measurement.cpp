#include "studies/verdicts/measurement.hpp"

#include "stats/error_rates/power.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace ff::studies::gates {
namespace {

using test::eight_values;

constexpr Levels usual_levels{.fail_alpha = 0.01, .pass_alpha = 0.05, .power = 0.9};

// stats.t.interval(.9, 7, x.mean() - 3, stats.sem(x)), and .99
TEST(MeasureMean, IsStudentsIntervalAtBothLevelsWhereNothingIsSkewed) {
    const auto measurement = measure_mean(eight_values, {.value = 3}, {-1, 1}, usual_levels, stats::not_skewed);
    EXPECT_NEAR(measurement->value, 1.15, 1e-14);
    EXPECT_NEAR(measurement->passing.low, -0.5547447946823611, 1e-13);
    EXPECT_NEAR(measurement->passing.high, 2.854744794682361, 1e-13);
    EXPECT_DOUBLE_EQ(measurement->passing.level, 0.9);
    EXPECT_DOUBLE_EQ(measurement->failing.level, 0.99);
    EXPECT_LT(measurement->failing.low, measurement->passing.low);
    EXPECT_EQ(measurement->passing.method, "skewed_t");
}

TEST(MeasureMean, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(measure_mean(std::array{1.0, 2.0}, {.value = 1}, {-1, 1}, usual_levels));
    EXPECT_FALSE(measure_mean(std::array{1.0, 1.0, 1.0}, {.value = 1}, {-1, 1}, usual_levels));
}

TEST(MeasureMean, AllowsForAnUncertainReference) {
    const double own = *stats::moments_of(eight_values, 3).standard_error();
    const auto measure = [](const MeanReference& reference) {
        return measure_mean(eight_values, reference, {-1, 1}, usual_levels, stats::not_skewed);
    };
    const auto certain = measure({.value = 3});
    const auto same = measure({.value = 3, .standard_error = own, .freedom = 7});
    EXPECT_EQ(same->passing.method, "skewed_welch_t");
    // Equal parts: sqrt(2) the error, twice the freedom. stats.t.ppf(.95, 14) = 1.7613101357748562
    EXPECT_NEAR(same->passing.width() / 2, std::sqrt(2) * own * 1.7613101357748562, 1e-12);
    EXPECT_GT(same->minimum_detectable, certain->minimum_detectable);
}

// Risks: false alarm 1e-6; a fail rate off by .03 at the power is noticed with power .99.
TEST(MeasureMean, FailsAtTheMinimumDetectableEffectWithItsPower) {
    std::mt19937_64 engine(11);
    const Band band{-0.3, 0.3};
    constexpr std::size_t trials = 40;
    const double effect =
        0.3 + stats::minimum_detectable_bias(1, trials, {usual_levels.fail_alpha, usual_levels.power});
    const auto fails = [&] {
        const auto values = test::normal_sample(trials, engine, effect);
        return judge(measure_mean(values, {}, band, usual_levels, stats::not_skewed), band) == Verdict::fail;
    };
    constexpr std::uint64_t runs = 6000;
    EXPECT_TRUE(test::has_probability(test::count_events(runs, fails), runs, usual_levels.power,
                                      {.alpha = 1e-6, .detects = 0.03}));
}

TEST(MeasureMean, StatesTheMinimumDetectableEffectWithinAPercent) {
    std::mt19937_64 engine(12);
    for (const std::size_t trials : {8u, 40u, 1000u}) {
        for (const double alpha : {0.01, 1e-7}) {
            const auto values = test::normal_sample(trials, engine);
            const Levels strict{.fail_alpha = alpha, .pass_alpha = 0.05, .power = 0.9};
            const double shift = measure_mean(values, {}, {-1, 1}, strict, stats::not_skewed)->minimum_detectable - 1;
            const double sigma = *stats::moments_of(values).standard_deviation();
            const double exact = stats::minimum_detectable_bias(sigma, trials, {alpha, 0.9});
            EXPECT_NEAR(shift, exact, 0.01 * exact) << trials << " trials, alpha " << alpha;
        }
    }
}

TEST(MeasureMean, DetectsLessWhereValuesMayBeSkewed) {
    std::mt19937_64 engine(13);
    const auto values = test::normal_sample(40, engine);
    const auto known = measure_mean(values, {}, {-1, 1}, usual_levels, stats::not_skewed);
    const auto unknown = measure_mean(values, {}, {-1, 1}, usual_levels);
    EXPECT_GT(unknown->minimum_detectable, known->minimum_detectable);
    EXPECT_LT(unknown->failing.low, known->failing.low);
}

/// How often a point null fails at alpha = 0.01 beside a reference that is the mean of ten exponential values.
std::uint64_t false_alarms_beside_few_values(std::uint64_t repetitions, bool says_how_skewed) {
    std::mt19937_64 engine(29);
    std::exponential_distribution<double> law;
    std::uint64_t failed = 0;
    for (std::uint64_t i = 0; i < repetitions; ++i) {
        std::vector<double> before(10);
        std::vector<double> now(200);
        for (auto* values : {&before, &now}) std::ranges::generate(*values, [&] { return law(engine); });
        const auto mean = *stats::mean_evidence(before, 0);
        MeanReference reference{mean.difference, mean.standard_error, mean.freedom, mean.skewness};
        if (!says_how_skewed) reference.skewness = {.most = stats::no_part};
        const Band point{-1e-12, 1e-12};
        if (judge(measure_mean(now, reference, point, usual_levels), point) == Verdict::fail) ++failed;
    }
    return failed;
}

// Risks: false alarm 1e-6 at a rate of .015; a rate of .04 is noticed with power .99.
TEST(MeasureMean, AllowsForTheSkewnessOfItsReference) {
    EXPECT_TRUE(test::has_probability_at_most(false_alarms_beside_few_values(3000, true), 3000, 0.015,
                                              {.alpha = 1e-6, .detects = 0.025}));
    EXPECT_FALSE(test::has_probability_at_most(false_alarms_beside_few_values(3000, false), 3000, 0.015,
                                               {.alpha = 1e-6, .detects = 0.025}))
        << "without it, the rule fails too often";
}

// An effect as large as what is stated to be detectable, measured where its interval is as wide, leaves the band.
TEST(AllowForSkewness, WidensTheDetectableEffectAsWell) {
    std::mt19937_64 engine(31);
    const auto values = test::normal_sample(50, engine);
    const auto spread = *stats::mean_square_of(stats::moments_of(values));
    stats::Measured ratio = *logarithm_of_spread(values, *stats::moments_of(values).mean());
    ratio.value = 0;
    const Levels strict{.fail_alpha = 1e-4, .pass_alpha = 0.05, .power = 0.9};
    Measurement measurement = measure_spread(spread, spread, {0.8, 1.25}, strict);
    const double before = measurement.minimum_detectable;
    allow_for_skewness(measurement, ratio, true, {0.8, 1.25}, strict);
    EXPECT_GT(measurement.minimum_detectable, before);
    EXPECT_GT(measurement.minimum_detectable * measurement.failing.low / measurement.value, 1.25);
}

TEST(MeasureSpread, IsOneForTheReferenceItself) {
    const auto spread = *stats::mean_square_of(stats::moments_of(eight_values));
    const double sigma = std::sqrt(spread.mean_square);
    const Measurement measurement = measure_spread(spread, sigma, {0.5, 2}, usual_levels);
    EXPECT_DOUBLE_EQ(measurement.value, 1);
    EXPECT_LT(measurement.passing.low, 1);
    EXPECT_GT(measurement.passing.high, 1);
    EXPECT_GT(measurement.minimum_detectable, 2);
    const Measurement twice = measure_spread(spread, spread, {0.5, 2}, usual_levels);
    EXPECT_DOUBLE_EQ(twice.value, 1);
    EXPECT_LT(twice.passing.low, measurement.passing.low);
    EXPECT_NEAR(twice.passing.low * twice.passing.high, 1, 1e-12);
    EXPECT_EQ(twice.passing.method, "adjusted_f");
}

TEST(MeasureSpread, LooksBelowABandWithoutUpperEnd) {
    const auto spread = *stats::mean_square_of(stats::moments_of(eight_values));
    EXPECT_LT(
        measure_spread(spread, 1, {0.9, std::numeric_limits<double>::infinity()}, usual_levels).minimum_detectable,
        0.9);
}

TEST(MeasureProportion, IsClopperPearson) {
    const Measurement measurement = measure_proportion({.hits = 95, .trials = 100}, {0.9, 1}, usual_levels);
    EXPECT_EQ(measurement.passing.method, "clopper_pearson");
    EXPECT_DOUBLE_EQ(measurement.value, 0.95);
    EXPECT_LT(measurement.minimum_detectable, 0.9);
}

TEST(MeasureSlope, FindsTheSlopeOfALadder) {
    std::mt19937_64 engine(5);
    std::vector<stats::Rung> ladder;
    for (const double size : {16.0, 64.0, 256.0}) {
        stats::Rung rung{size, test::normal_sample(200, engine, 0)};
        for (double& error : rung.errors) error /= std::sqrt(size);
        ladder.push_back(rung);
    }
    const auto measurement = measure_slope(ladder, {-0.7, -0.3}, usual_levels);
    EXPECT_TRUE(measurement->failing.contains(-0.5));
    EXPECT_EQ(judge(measurement, {-0.7, -0.3}), Verdict::pass);
    EXPECT_EQ(judge(measurement, {-1.2, -0.9}), Verdict::fail);
    ladder.resize(1);
    EXPECT_FALSE(measure_slope(ladder, {-0.7, -0.3}, usual_levels));
}

TEST(MeasureExact, DecidesWithOneEvaluation) {
    EXPECT_EQ(judge(measure_exactly(0.5, {-1, 1}), {-1, 1}), Verdict::pass);
    EXPECT_EQ(judge(measure_exactly(1.5, {-1, 1}), {-1, 1}), Verdict::fail);
}

}  // namespace
}  // namespace ff::studies::gates

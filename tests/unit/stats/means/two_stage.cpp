#include "stats/means/mean_interval.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/basics/moments.hpp"
#include "stats/means/mean_test.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ff::stats {
namespace {

constexpr double two_stage_level = 0.95;

TEST(TwoStage, PilotIsTheSpreadOfTheFirstValues) {
    const std::vector<double> values{1, 2, 3, 100};
    EXPECT_NEAR(pilot_of(values, 3)->standard_deviation, 1, 1e-15);
    EXPECT_FALSE(pilot_of(values, 5));
    EXPECT_FALSE(pilot_of(std::vector<double>{1, 1, 2}, 2));
}

// from scipy.stats import t; t.ppf(.975, 9)**2 * 4 / .5**2 -> 81.88; 4 * 9/7 / .25 -> 20.57
TEST(TwoStage, AsksForAsManyTrialsAsTheGoalNeeds) {
    const Pilot pilot{10, 2, {}};
    EXPECT_EQ(trials_for_half_width(pilot, 0.5, two_stage_level), 82u);
    EXPECT_EQ(trials_for_rmse(pilot, 0.5), 21u);
    EXPECT_EQ(trials_for_rmse(pilot, 5), 10u);
    EXPECT_LE(half_width_of(pilot, 82, two_stage_level), 0.5);
    EXPECT_GT(half_width_of(pilot, 81, two_stage_level), 0.5);
    EXPECT_LE(rmse_of(pilot, 21), 0.5);
    EXPECT_GT(rmse_of(pilot, 20), 0.5);
    EXPECT_EQ(trials_for_half_width(pilot, 1e-300, two_stage_level),
              trials_for_half_width(pilot, 1e-200, two_stage_level));
}

using Law = std::function<double()>;

/// Takes a pilot of 5, then as many values as the rule requires.
std::vector<double> run_two_stages(const Law& law, double half_width, Pilot& pilot) {
    std::vector<double> values(5);
    for (double& value : values) value = law();
    pilot = *pilot_of(values, values.size());
    for (std::uint64_t left = trials_for_half_width(pilot, half_width, two_stage_level) - values.size(); left > 0;
         --left)
        values.push_back(law());
    return values;
}

/// The rule that looks natural and is wrong: continue until Student's interval is short enough.
Moments run_until_it_looks_short(const Law& law, double half_width) {
    Moments all;
    for (int i = 0; i < 5; ++i) all.add(law());
    while (bias_interval_t(all, two_stage_level)->width() / 2 > half_width) all.add(law());
    return all;
}

// Standard normal values, half-width .5: about 4 to 100 trials. Risks: 1e-6; .92 is noticed with power .99.
TEST(TwoStage, KeepsItsCoverageOfNormalValues) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    const Law law = [&] { return normal(engine); };
    std::uint64_t covered = 0;
    constexpr std::uint64_t runs = 4000;
    for (std::uint64_t run = 0; run < runs; ++run) {
        Pilot pilot;
        const auto all = run_two_stages(law, 0.5, pilot);
        covered += interval_of(mean_evidence_after(pilot, all, 0), two_stage_level).contains(0) ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(covered, runs, two_stage_level, {.detects = 0.028}));
}

// A rule that is broken: it covers about .88.
TEST(TwoStage, StoppingAtAShortIntervalLosesCoverage) {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    const Law law = [&] { return normal(engine); };
    std::uint64_t covered = 0;
    constexpr std::uint64_t runs = 4000;
    for (std::uint64_t run = 0; run < runs; ++run)
        covered += bias_interval_t(run_until_it_looks_short(law, 0.5), two_stage_level)->contains(0) ? 1u : 0u;
    EXPECT_LT(binomial_lower_p({covered, runs}, two_stage_level), 1e-6);
}

// E (mean - truth)^2 is at most the square of the requested error, and not far below it.
TEST(TwoStage, KeepsThePromisedMeanSquaredError) {
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal(3, 2);
    std::vector<double> ratios;
    constexpr double rmse = 0.25;
    for (int run = 0; run < 4000; ++run) {
        std::vector<double> values(10);
        for (double& value : values) value = normal(engine);
        Moments all(3);
        for (const double value : values) all.add(value);
        const std::uint64_t trials = trials_for_rmse(*pilot_of(values, values.size()), rmse);
        for (std::uint64_t i = values.size(); i < trials; ++i) all.add(normal(engine));
        ratios.push_back(*all.bias() * *all.bias() / (rmse * rmse));
    }
    EXPECT_TRUE(test::unbiased(ratios, 1, {.alpha = 1e-6, .detects = 0.2}));
}

TEST(TwoStage, TestsAgreeWithTheInterval) {
    const std::vector<double> all{0.2, 0.5, -0.1, 0.4, 0.3, 0.2};
    const auto mean = mean_evidence_after({5, 0.2, {}}, all, 0);
    const Interval interval = interval_of(mean, two_stage_level);
    EXPECT_EQ(interval.contains(0), test_mean(mean).p >= 1 - two_stage_level);
    EXPECT_NEAR(interval.low + interval.high, 2 * mean.difference, 1e-15);
}

TEST(TwoStage, AsksForMoreTrialsWhereThePilotMayBeSkewed) {
    std::mt19937_64 engine(4);
    const auto values = test::normal_sample(40, engine);
    const Pilot normal = *pilot_of(values, 40);
    const Pilot skewed = *skewed_pilot_of(values, 40, unknown_parts);
    EXPECT_EQ(skewed_pilot_of(values, 40, no_part)->skewness.most, 0);
    const auto trials = trials_for_half_width(skewed, 0.2, two_stage_level);
    EXPECT_GT(trials, trials_for_half_width(normal, 0.2, two_stage_level));
    EXPECT_LE(half_width_of(skewed, trials, two_stage_level), 0.2);
    const auto mean = mean_evidence_after(skewed, values, 0);
    EXPECT_GT(interval_of(mean, 0.95).width(), interval_of(mean_evidence_after(normal, values, 0), 0.95).width());
}

}  // namespace
}  // namespace ff::stats

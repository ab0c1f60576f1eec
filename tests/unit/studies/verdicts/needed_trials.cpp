#include "studies/verdicts/measurement.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ff::studies::gates {
namespace {

constexpr Levels strict_levels{.fail_alpha = 1e-5, .pass_alpha = 0.05 / 3, .power = 0.9};

/// Share of runs without effect that pass is at least the power. Risks: false alarm 1e-6; a share smaller by 0.03 is
/// noticed with power .99.
template <class Passes>
void expect_power(const Passes& passes) {
    constexpr std::uint64_t runs = 4000;
    EXPECT_TRUE(test::has_probability_at_least(test::count_events(runs, passes), runs, strict_levels.power,
                                               {.alpha = 1e-6, .detects = 0.04}));
}

TEST(NeededTrials, LetAMeanWithoutBiasPassWithTheStatedPower) {
    std::mt19937_64 engine(1);
    for (const double sigma : {1.0, 2.0}) {
        const Band band{-0.5, 0.5};
        const auto trials = *trials_for_mean(0.5, sigma, 0, 0, strict_levels, 1);
        expect_power([&] {
            const auto values = test::normal_sample(trials, engine, 0, sigma);
            return judge(measure_mean(values, {}, band, strict_levels), band) == Verdict::pass;
        });
    }
}

TEST(NeededTrials, AllowForAnUncertainReferenceAsLongAsTheBandIsWider) {
    std::mt19937_64 engine(2);
    const Band band{-0.5, 0.5};
    constexpr double error = 0.08;
    const auto trials = *trials_for_mean(0.5, 1, 0, error, strict_levels, 1);
    EXPECT_GT(trials, *trials_for_mean(0.5, 1, 0, 0, strict_levels, 1));
    expect_power([&] {
        const double reference = std::normal_distribution<double>(0, error)(engine);
        const auto values = test::normal_sample(trials, engine);
        return judge(measure_mean(values, {.value = reference, .standard_error = error}, band, strict_levels), band) ==
               Verdict::pass;
    });
    EXPECT_FALSE(trials_for_mean(0.5, 1, 0, 0.5, strict_levels, 1));
}

TEST(NeededTrials, GrowWithComparisonsAndSkewness) {
    EXPECT_GT(*trials_for_mean(0.1, 1, 0, 0, strict_levels, 30), *trials_for_mean(0.1, 1, 0, 0, strict_levels, 1));
    const auto skewed = *trials_for_mean(0.1, 1, 1, 0, strict_levels, 1);
    // exp(z^3 g / (3 sqrt(T))) = 2 at z = 4.417173, two-sided 1e-5
    EXPECT_NEAR(std::exp(std::pow(4.417173, 3) / (3 * std::sqrt(static_cast<double>(skewed)))), 2, 1e-2);
    EXPECT_GE(*trials_for_mean(1e9, 1, 0, 0, strict_levels, 1), 32u);
    EXPECT_EQ(*trials_for_mean(1, 0, 0, 0, strict_levels, 1), 32u);
}

TEST(NeededTrials, AreEmptyWhenNoNumberOfTrialsSuffices) {
    EXPECT_FALSE(trials_for_mean(1e-12, 1, 0, 0, strict_levels, 1));
    EXPECT_FALSE(trials_for_ratio({0.9, 1.1}, 0, 10, strict_levels, 1));
    EXPECT_FALSE(trials_for_proportion({0.5, 0.9}, 0.5, strict_levels, 1));
}

TEST(NeededTrials, LetARatioOfOnePassWithTheStatedPower) {
    std::mt19937_64 engine(3);
    const Band band{1 / 1.2, 1.2};
    const auto trials = *trials_for_ratio(band, 0, std::numeric_limits<double>::infinity(), strict_levels, 1);
    expect_power([&] {
        const auto spread = stats::mean_square_of(stats::moments_of(test::normal_sample(trials, engine)));
        return judge(measure_spread(*spread, 1, band, strict_levels), band) == Verdict::pass;
    });
}

TEST(NeededTrials, LetARatioToABaselinePassWithTheStatedPower) {
    std::mt19937_64 engine(4);
    const Band band{1 / 1.2, 1.2};
    constexpr std::size_t stored = 800;
    const auto trials = *trials_for_ratio(band, 0, stored - 1, strict_levels, 1);
    expect_power([&] {
        const auto then = stats::mean_square_of(stats::moments_of(test::normal_sample(stored, engine)));
        const auto now = stats::mean_square_of(stats::moments_of(test::normal_sample(trials, engine)));
        return judge(measure_spread(*now, *then, band, strict_levels), band) == Verdict::pass;
    });
}

TEST(NeededTrials, LetACoveragePassWithTheStatedPower) {
    std::mt19937_64 engine(5);
    const Band band{0.93, 0.97};
    const auto trials = *trials_for_proportion(band, 0.95, strict_levels, 1);
    expect_power([&] {
        const auto hits = std::binomial_distribution<std::uint64_t>(trials, 0.95)(engine);
        return judge(measure_proportion({.hits = hits, .trials = trials}, band, strict_levels), band) == Verdict::pass;
    });
}

TEST(NeededTrials, LetASlopePassWithTheStatedPower) {
    std::mt19937_64 engine(6);
    const std::vector<double> sizes{16, 64, 256};
    const Band band{-0.6, -0.4};
    const auto trials = *trials_for_slope(band, sizes, 1, strict_levels, 1);
    expect_power([&] {
        std::vector<stats::Rung> ladder;
        for (const double size : sizes)
            ladder.push_back({size, test::normal_sample(trials, engine, 0, 1 / std::sqrt(size))});
        return judge(measure_slope(ladder, band, strict_levels), band) == Verdict::pass;
    });
}

TEST(RaysForLoss, SufficeToSeeOneLostRayWithTheStatedPower) {
    const double rays = rays_for_loss(1e-3, strict_levels);
    EXPECT_LE(std::pow(1 - 1e-3, rays), 0.1);
    EXPECT_GT(std::pow(1 - 1e-3, rays - 1), 0.1);
}

}  // namespace
}  // namespace ff::studies::gates

#include "stats/convergence/convergence.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace ff::stats {
namespace {

constexpr std::size_t ladder_replicates = 64;

/// Errors that fall as size^rate, with replicates of the given law.
template <class Distribution>
std::vector<Rung> ladder(double rate, Distribution law, std::mt19937_64& engine) {
    std::vector<Rung> rungs;
    for (const double size : {256.0, 1024.0, 4096.0, 16'384.0, 65'536.0}) {
        rungs.push_back({size, test::sample(law, ladder_replicates, engine)});
        for (double& error : rungs.back().errors) error *= std::pow(size, rate);
    }
    return rungs;
}

ResamplingPlan plan_of_run(std::uint32_t run, std::uint32_t resamples = 199) {
    return {.key = {.word0 = 9, .word1 = run}, .replicates = resamples};
}

// from scipy.special import polygamma; polygamma(1, 2.5), polygamma(1, 32)
TEST(LogChiSquaredVariance, IsTrigamma) {
    EXPECT_NEAR(log_chi_squared_variance(5), 0.4903577561002349, 1e-14);
    EXPECT_NEAR(log_chi_squared_variance(64), 0.03174336652030209, 1e-15);
}

TEST(RmseRate, IsExactForErrorsThatFollowAPowerLaw) {
    std::vector<Rung> rungs;
    for (const double size : {10.0, 100.0, 1000.0}) {
        const double error = std::pow(size, -0.75);
        rungs.push_back({size, {error, -error, 2 * error, -2 * error}});
    }
    const auto rmse = fit_rmse_rate(rungs, 0.95, plan_of_run(0));
    EXPECT_NEAR(rmse->rate, -0.75, 1e-12);
    EXPECT_NEAR(*rmse->lack_of_fit_p, 1, 1e-9);
    EXPECT_EQ(rmse->points, 3u);
    EXPECT_TRUE(rmse->bootstrap.contains(-0.75));
    EXPECT_NEAR(fit_median_rate(rungs, 0.95, plan_of_run(0))->rate, -0.75, 1e-12);
}

// 20 000 replicates in blocks of five. The width of the bootstrap interval is known to 3 % from 999 resamples and to 1
// % from 4000 blocks; five standard errors. Blocks that counted as one replicate would make it sqrt(5) times as wide.
TEST(RmseRate, HasTheSameIntervalWhereBlocksAreDrawn) {
    std::mt19937_64 engine(4);
    std::vector<Rung> rungs;
    for (const double size : {16.0, 64.0, 256.0}) {
        rungs.push_back({size, test::normal_sample(20'000, engine)});
        for (double& error : rungs.back().errors) error /= std::sqrt(size);
    }
    const auto rate = fit_rmse_rate(rungs, 0.95, plan_of_run(1, 999));
    EXPECT_NEAR(rate->bootstrap.width() / rate->interval.width(), 1, 0.17);
}

TEST(LadderDraws, DrawSingleReplicatesOrBlocksOfMany) {
    const LadderDraws draws(std::array<std::size_t, 3>{5, LadderDraws::most_blocks, 10'001}, plan_of_run(1, 2));
    const std::array<std::size_t, 3> block{1, 1, 3};
    const std::array<std::size_t, 3> blocks{5, LadderDraws::most_blocks, 3334};
    for (std::size_t rung = 0; rung < blocks.size(); ++rung) {
        const auto counts = draws.counts(1, rung);
        EXPECT_EQ(draws.block(rung), block[rung]);
        EXPECT_EQ(counts.size(), blocks[rung]);
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), blocks[rung]);
        EXPECT_FALSE(std::equal(counts.begin(), counts.end(), draws.counts(0, rung).begin()));
    }
}

TEST(RmseRate, IsEmptyWhereNoLineIsDetermined) {
    const Rung good{16, {0.1, -0.2, 0.1}};
    const Rung exact{64, {0, 0, 0}};
    const Rung single{64, {0.1}};
    for (const auto& rungs : {std::vector<Rung>{}, std::vector{good}, std::vector{good, good}, std::vector{good, exact},
                              std::vector{good, single}}) {
        EXPECT_FALSE(fit_rmse_rate(rungs, 0.95, plan_of_run(0)));
        EXPECT_FALSE(fit_median_rate(rungs, 0.95, plan_of_run(0)));
    }
}

struct RateCoverage {
    std::uint64_t wls = 0, bootstrap = 0, median = 0, lack_of_fit = 0;
};

template <class Distribution>
RateCoverage rate_coverage(std::uint32_t runs, Distribution law, std::mt19937_64& engine) {
    RateCoverage count;
    for (std::uint32_t run = 0; run < runs; ++run) {
        const auto rungs = ladder(-0.5, law, engine);
        const auto rmse = fit_rmse_rate(rungs, 0.95, plan_of_run(run));
        count.wls += rmse->interval.contains(-0.5) ? 1u : 0u;
        count.bootstrap += rmse->bootstrap.contains(-0.5) ? 1u : 0u;
        count.lack_of_fit += *rmse->lack_of_fit_p < 0.05 ? 1u : 0u;
        count.median += fit_median_rate(rungs, 0.95, plan_of_run(run, 99))->interval.contains(-0.5) ? 1u : 0u;
    }
    return count;
}

// Risks: 1e-6; coverage off by .068 is noticed with power .99.
TEST(RmseRate, CoversTheTrueRateOfNormalErrors) {
    std::mt19937_64 engine(1);
    const RateCoverage count = rate_coverage(800, std::normal_distribution<double>(), engine);
    EXPECT_TRUE(test::has_probability(count.wls, 800, 0.95, {.detects = 0.068}));
    EXPECT_TRUE(test::has_probability(count.lack_of_fit, 800, 0.05, {.detects = 0.068}));
    EXPECT_TRUE(test::has_probability_at_least(count.bootstrap, 800, 0.92, {.detects = 0.079}));
    EXPECT_TRUE(test::has_probability_at_least(count.median, 800, 0.92, {.detects = 0.079}));
}

// Student t(6): excess kurtosis 3, for which the weights of normal errors would cover .78.
TEST(RmseRate, CoversTheTrueRateUnderKurtosis) {
    std::mt19937_64 engine(2);
    const RateCoverage count = rate_coverage(500, std::student_t_distribution<double>(6), engine);
    EXPECT_TRUE(test::has_probability_at_least(count.wls, 500, 0.9, {.detects = 0.12}));
    EXPECT_TRUE(test::has_probability_at_least(count.bootstrap, 500, 0.88, {.detects = 0.12}));
}

// Student t(1.5): infinite variance, as the area kernel has on faces that share an edge.
TEST(MedianRate, SurvivesInfiniteVariance) {
    std::mt19937_64 engine(3);
    const RateCoverage count = rate_coverage(500, std::student_t_distribution<double>(1.5), engine);
    EXPECT_TRUE(test::has_probability_at_least(count.median, 500, 0.92, {.detects = 0.11}));
}

/// Four errors a replicate, that share as much as they have of their own: correlation 1/2.
std::vector<Rung> joint_ladder(std::mt19937_64& engine) {
    std::vector<Rung> rungs;
    for (const double size : {256.0, 1024.0, 4096.0, 16'384.0, 65'536.0}) {
        Rung& rung = rungs.emplace_back();
        rung.size = size;
        rung.width = 4;
        std::normal_distribution<double> normal;
        for (std::size_t replicate = 0; replicate < ladder_replicates; ++replicate) {
            const double shared = normal(engine);
            for (std::size_t i = 0; i < rung.width; ++i)
                rung.errors.push_back((shared + normal(engine)) / std::sqrt(size));
        }
    }
    return rungs;
}

// Errors taken for independent ones would cover .84. Risks: 1e-6; .87 is noticed with power .99.
TEST(RmseRate, CoversTheTrueRateWhereErrorsOfAReplicateDependOnEachOther) {
    std::mt19937_64 engine(6);
    std::uint64_t wls = 0;
    std::uint64_t bootstrap = 0;
    for (std::uint32_t run = 0; run < 600; ++run) {
        const auto rate = fit_rmse_rate(joint_ladder(engine), 0.95, plan_of_run(run));
        wls += rate->interval.contains(-0.5) ? 1u : 0u;
        bootstrap += rate->bootstrap.contains(-0.5) ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(wls, 600, 0.95, {.detects = 0.081}));
    EXPECT_TRUE(test::has_probability_at_least(bootstrap, 600, 0.92, {.detects = 0.093}));
}

TEST(RmseRate, ShowsLackOfFitForAChangingRate) {
    std::mt19937_64 engine(4);
    std::uint64_t found = 0;
    for (std::uint32_t run = 0; run < 100; ++run) {
        auto rungs = ladder(-0.5, std::normal_distribution<double>(), engine);
        for (Rung& rung : rungs) {
            for (double& error : rung.errors) error += 0.01;  // a bias that random errors fall below
        }
        found += *fit_rmse_rate(rungs, 0.95, plan_of_run(run))->lack_of_fit_p < 0.05 ? 1u : 0u;
    }
    EXPECT_GT(found, 80u);
}

// Of 300 straight ladders at 5 %, more than 30 are called bent with probability 2e-4; by chi-squared, 90 of these are.
// A bias that random errors fall below is found in at least 80 of 100 ladders, as by chi-squared.
TEST(StraightLine, HoldsForSkewedErrors) {
    std::mt19937_64 engine(7);
    std::lognormal_distribution<double> law(0, 1);
    const double mean = std::exp(0.5);
    const std::vector<Unmet> unmet(5);
    int bent = 0;
    int bent_by_chi_squared = 0;
    for (std::uint32_t run = 0; run < 300; ++run) {
        auto rungs = ladder(0, law, engine);
        for (Rung& rung : rungs) {
            for (double& error : rung.errors) error = (error - mean) / std::sqrt(rung.size);
        }
        bent += p_of_straight_line(rungs, unmet) < 0.05 ? 1 : 0;
        bent_by_chi_squared += *fit_rmse_rate(rungs, 0.95, plan_of_run(run, 1))->lack_of_fit_p < 0.05 ? 1 : 0;
    }
    EXPECT_LE(bent, 30);
    EXPECT_GE(bent_by_chi_squared, 60);
    int found = 0;
    for (std::uint32_t run = 0; run < 100; ++run) {
        auto rungs = ladder(-0.5, std::normal_distribution<double>(), engine);
        for (Rung& rung : rungs) {
            for (double& error : rung.errors) error += 0.01;
        }
        found += p_of_straight_line(rungs, unmet) < 0.05 ? 1 : 0;
    }
    EXPECT_GE(found, 80);
}

TEST(RmseRate, IsTheSameForTheSameKey) {
    std::mt19937_64 engine(5);
    const auto rungs = ladder(-0.5, std::normal_distribution<double>(), engine);
    EXPECT_EQ(fit_rmse_rate(rungs, 0.95, plan_of_run(1))->bootstrap.low,
              fit_rmse_rate(rungs, 0.95, plan_of_run(1))->bootstrap.low);
    EXPECT_NE(fit_rmse_rate(rungs, 0.95, plan_of_run(1))->bootstrap.low,
              fit_rmse_rate(rungs, 0.95, plan_of_run(2))->bootstrap.low);
}

}  // namespace
}  // namespace ff::stats

#include "stats/dependence/repeats.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace ff::stats {
namespace {

/// Hits of `rays` rays over `rays`: multiples of 1 / rays, none of them exact in binary.
std::vector<double> counted(std::size_t n, int rays, double p, std::mt19937_64& engine) {
    std::vector<double> values;
    std::binomial_distribution<int> hits(rays, p);
    for (std::size_t i = 0; i < n; ++i) values.push_back(hits(engine) / static_cast<double>(rays));
    return values;
}

std::vector<double> printed(std::vector<double> values, double unit) {
    for (double& value : values) value = std::round(value / unit) * unit;
    return values;
}

TEST(FindRepeats, FindsNoneAmongRealNumbers) {
    std::mt19937_64 engine(1);
    EXPECT_FALSE(find_repeats(test::normal_sample(10'000, engine)));
}

TEST(FindRepeats, FindsASingleRealNumberThatOccursTwice) {
    std::mt19937_64 engine(2);
    std::vector<double> values = test::normal_sample(100, engine, 0.2, 1e-3);
    values[70] = values[3];
    const auto found = find_repeats(values);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->repeats, 1u);
    EXPECT_EQ(found->earlier, 3u);
    EXPECT_EQ(found->later, 70u);
    EXPECT_EQ(found->p, 0);
    EXPECT_FALSE(found->certain) << "an estimator may give one value where nothing happens";
}

TEST(FindRepeats, AllowsForCountsAndForRoundedFigures) {
    std::mt19937_64 engine(3);
    for (int i = 0; i < 200; ++i) {
        for (const std::size_t n : {20u, 100u, 1000u}) {
            for (const auto& values : {counted(n, 625, 0.2, engine), counted(n, 100'000, 0.2, engine),
                                       printed(test::normal_sample(n, engine, 0.2, 1e-3), 1e-5)}) {
                const auto found = find_repeats(values);
                EXPECT_TRUE(!found || found->p > 1e-6) << n << ": " << found->repeats << " for " << found->expected;
            }
        }
    }
}

TEST(FindRepeats, PredictsHowManyCountsCoincide) {
    std::mt19937_64 engine(4);
    double repeats = 0;
    double expected = 0;
    for (int i = 0; i < 200; ++i) {
        const auto found = find_repeats(counted(300, 10'000, 0.2, engine));
        ASSERT_TRUE(found);
        repeats += static_cast<double>(found->repeats);
        expected += found->expected;
    }
    EXPECT_NEAR(repeats / expected, 1, 0.05);  // some 200 * 175 repeats: a standard error of 0.004
}

TEST(FindRepeats, FindsAQuarterOfTheTrialsCopiedAmongCounts) {
    std::mt19937_64 engine(5);
    std::vector<double> values = counted(400, 1'000'000, 0.2, engine);
    for (std::size_t i = 0; i < 100; ++i) values[i + 200] = values[i];
    EXPECT_LT(find_repeats(values)->p, 1e-6);
}

TEST(FindRepeats, AllowsForCountsOfRareOrClusteredEvents) {
    std::mt19937_64 engine(6);
    std::poisson_distribution<int> rare(0.1);
    std::poisson_distribution<int> one(1);
    std::negative_binomial_distribution<int> few(1, 1.0 / 6);
    std::gamma_distribution<double> half(0.5);
    std::exponential_distribution<double> size;
    std::bernoulli_distribution nothing(0.7);
    for (int i = 0; i < 1000; ++i) {
        std::vector<std::vector<double>> files(6, std::vector<double>(100));
        for (std::size_t k = 0; k < 100; ++k) {
            files[0][k] = rare(engine);
            files[1][k] = one(engine);
            files[2][k] = few(engine);
            files[3][k] = std::poisson_distribution<int>(100 * half(engine))(engine);
            files[4][k] = nothing(engine) ? 0 : size(engine);
            files[5][k] = std::max(0.2, size(engine));  // cut off at its least value
        }
        for (std::size_t f = 0; f < files.size(); ++f) {
            const auto found = find_repeats(files[f]);
            EXPECT_TRUE(!found || found->p > 1e-6) << f << ": " << found->repeats << " for " << found->expected;
        }
    }
}

TEST(FindRepeats, AllowsForFiguresOfThreeDigitsOverManyDecades) {
    std::mt19937_64 engine(7);
    std::lognormal_distribution<double> wide(0, 1.5);
    for (int i = 0; i < 500; ++i) {
        std::vector<double> values(100);
        for (double& value : values) {
            const double exact = wide(engine);
            const double unit = std::pow(10.0, std::floor(std::log10(exact)) - 2);
            value = std::stod(std::to_string(std::lround(exact / unit)) + "e" +
                              std::to_string(static_cast<int>(std::floor(std::log10(exact))) - 2));
        }
        const auto found = find_repeats(values);
        EXPECT_TRUE(!found || found->p > 1e-6) << found->repeats << " for " << found->expected;
    }
}

TEST(FindRepeats, FindsTrialsOfFiveSeeds) {
    std::mt19937_64 engine(8);
    std::uniform_int_distribution<std::size_t> seed(0, 4);
    for (const auto& distinct : {test::normal_sample(5, engine), counted(5, 100'000, 0.2, engine)}) {
        std::vector<double> values(100);
        for (double& value : values) value = distinct[seed(engine)];
        const auto found = find_repeats(values);
        ASSERT_TRUE(found);
        EXPECT_LT(found->p, 1e-6);
    }
}

std::vector<double> to_digits(std::vector<double> values, int digits) {
    for (double& value : values) value = std::stod(fmt::format("{:.{}g}", value, digits));
    return values;
}

// None of 100 runs of each kind is refused: a kind that is refused with a probability of 0.1 % would be noticed with a
// probability of 0.1. An earlier rule refused nearly all of the shares and sums.
TEST(FindRepeats, DoesNotAccuseHonestEstimatesOfFewDigitsOrFewValues) {
    std::mt19937_64 engine(12);
    std::normal_distribution<double> normal;
    std::bernoulli_distribution nothing(0.5);
    for (int i = 0; i < 100; ++i) {
        std::vector<std::vector<double>> kinds;
        for (const int rays : {3, 7, 12, 30, 300}) kinds.push_back(counted(100, rays, 0.2, engine));
        for (const double sigma : {3e-4, 3e-3, 0.03}) kinds.push_back(test::normal_sample(100, engine, 0.2, sigma));
        std::vector<double> sums = counted(100, 16, 0.3, engine);  // of hits from two surfaces of different area
        const std::vector<double> others = counted(100, 16, 0.2, engine);
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = sums[k] * 0.31830988 + others[k] * 0.68169012;
        kinds.push_back(sums);
        std::vector<double> corrections(100, 0.2);  // of a control variate that often is exact
        for (double& value : corrections) value += nothing(engine) ? 0 : 0.01 * normal(engine);
        kinds.push_back(corrections);
        std::vector<double> rare(100, 0.0);
        for (double& value : rare) value = std::max(0.0, normal(engine) - 1);
        kinds.push_back(rare);
        for (const auto& values : kinds) {
            for (const int digits : {2, 3, 4, 6, 10, 17}) {
                const auto found = find_repeats(to_digits(values, digits));
                EXPECT_FALSE(found && found->certain && found->p < 1e-6)
                    << digits << " digits: " << found->repeats << " for " << found->expected;
            }
        }
    }
}

// To six digits, as C++ prints by default, seeds that repeat look like an estimator that takes few values.
TEST(FindRepeats, IsCertainOfFewSeedsWhereTenDigitsArePrinted) {
    std::mt19937_64 engine(13);
    std::uniform_int_distribution<std::size_t> seed(0, 63);
    for (int i = 0; i < 100; ++i) {
        const auto distinct = test::normal_sample(64, engine, 0.2, 1e-3);
        std::vector<double> values(100);
        for (double& value : values) value = distinct[seed(engine)];
        for (const int digits : {6, 10, 17}) {
            const auto found = find_repeats(to_digits(values, digits));
            ASSERT_TRUE(found);
            EXPECT_LT(found->p, 1e-6);
            EXPECT_EQ(found->certain, digits >= 10) << digits;
        }
    }
}

/// Trials drawn from the columns of some series, as by a program that uses few bits of its seed.
std::size_t repeated_of(std::vector<std::vector<double>> series, std::size_t seeds, std::mt19937_64& engine) {
    std::uniform_int_distribution<std::size_t> seed(0, seeds - 1);
    std::vector<std::size_t> seed_of(series.front().size());
    for (std::size_t& each : seed_of) each = seed(engine);
    for (auto& values : series) {
        const auto all = values;
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = all[seed_of[i]];
    }
    return repeated_trials(std::vector<std::span<const double>>(series.begin(), series.end()));
}

std::size_t repeated_of(const std::vector<std::vector<double>>& series) {
    return repeated_trials(std::vector<std::span<const double>>(series.begin(), series.end()));
}

TEST(RepeatedTrials, AreFoundWhereFewSeedsAreUsed) {
    std::mt19937_64 engine(9);
    for (const std::size_t seeds : {2u, 3u, 4u, 8u, 64u}) {
        const auto found =
            repeated_of({test::normal_sample(100, engine), test::normal_sample(100, engine)}, seeds, engine);
        EXPECT_GE(found, 100 - seeds);
        EXPECT_EQ(repeated_of({counted(100, 1'000'000, 0.2, engine)}, seeds, engine), 0u);  // counts tell nothing
    }
}

TEST(RepeatedTrials, AreNotFoundWhereOnlySomeSeriesRepeat) {
    std::mt19937_64 engine(10);
    std::vector<double> coarse(100);
    for (std::size_t i = 0; i < coarse.size(); ++i) coarse[i] = std::sqrt(static_cast<double>(i % 5));
    EXPECT_EQ(repeated_of({coarse, test::normal_sample(100, engine)}), 0u);
}

TEST(RepeatedTrials, AreNotFoundAmongSoundOnes) {
    std::mt19937_64 engine(11);
    std::bernoulli_distribution nothing(0.6);
    for (int i = 0; i < 300; ++i) {
        const auto near = counted(100, 16, 0.3, engine);
        const auto far = counted(100, 16, 0.2, engine);
        std::vector<double> sums(100);  // of hits from two surfaces of different area
        std::vector<double> ratios(100);
        std::vector<double> corrections(100);
        for (std::size_t k = 0; k < 100; ++k) {
            sums[k] = near[k] * 0.31830988 + far[k] * 0.68169012;
            ratios[k] = far[k] / std::max(near[k], 1.0 / 16);
            corrections[k] = 0.2 + (nothing(engine) ? 0 : std::normal_distribution<double>(0, 0.01)(engine));
        }
        EXPECT_EQ(repeated_of({sums}), 0u);
        EXPECT_EQ(repeated_of({ratios}), 0u);
        EXPECT_EQ(repeated_of({corrections}), 0u);
        EXPECT_EQ(repeated_of({near, far}), 0u);
        EXPECT_EQ(repeated_of({counted(100, 100, 0.003, engine)}), 0u);
        EXPECT_EQ(repeated_of({counted(100, 100'000, 0.2, engine)}), 0u);
    }
    EXPECT_EQ(repeated_of({std::vector<double>(100, 0.2)}), 0u);
}

TEST(RepeatedTrials, AreNotFoundAmongShiftedAndWeightedCounts) {
    std::mt19937_64 engine(13);
    for (int i = 0; i < 100; ++i) {
        auto shifted = counted(30, 1000, 0.001, engine);
        auto weighted = counted(12, 6, 0.4, engine);
        auto roots = counted(100, 200, 0.4, engine);
        for (double& value : shifted) value = std::sqrt(0.05) - value;
        for (double& value : weighted) value *= std::sqrt(0.02);
        for (double& value : roots) value = std::sqrt(value * (1 - value) / 200);
        EXPECT_EQ(repeated_of({shifted}), 0u);
        EXPECT_EQ(repeated_of({weighted}), 0u);
        const auto found = find_repeats(roots);
        EXPECT_FALSE(found && found->certain);
    }
}

TEST(FindRepeats, CountsAllRepeatsOfTwoToFourRealValues) {
    std::mt19937_64 engine(14);
    for (const std::size_t seeds : {2u, 3u, 4u}) {
        const auto different = test::normal_sample(seeds, engine);
        std::vector<double> values(100);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = different[i % seeds];
        const auto found = find_repeats(values);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->in_all, 100 - seeds);
        EXPECT_EQ(found->later, seeds);
    }
}

TEST(RepeatedTrials, AreNotFoundAmongZerosAndOneOtherValue) {
    std::mt19937_64 engine(12);
    std::bernoulli_distribution hit(0.4);
    std::vector<double> shadow(100);  // an exact factor, or 0 behind a blocker
    for (double& value : shadow) value = hit(engine) ? std::sqrt(0.02) : 0;
    EXPECT_EQ(repeated_of({shadow}), 0u);
    EXPECT_EQ(repeated_of({test::normal_sample(100, engine), shadow}), 0u);
}

TEST(FindPeriod, FindsTwoEqualHalvesOfCoarseCounts) {
    std::mt19937_64 engine(6);
    std::vector<double> values = counted(100, 30, 0.2, engine);
    for (std::size_t i = 0; i < 50; ++i) values[i + 50] = values[i];
    EXPECT_EQ(find_period(values, 1e-6), 50u);
}

TEST(FindPeriod, FindsNoneInRandomRepeats) {
    std::mt19937_64 engine(7);
    EXPECT_FALSE(find_period(test::normal_sample(1000, engine), 1e-6));
    EXPECT_FALSE(find_period(std::vector<double>(1000, 0.0), 1e-6));  // hits so rare that none was seen
}

}  // namespace
}  // namespace ff::stats

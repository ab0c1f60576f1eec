#include "stats/dependence/correlation.hpp"

#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::stats {
namespace {

/// Autoregressive series of order one: x_i = rho x_(i-1) + noise, started in its stationary distribution.
std::vector<double> autoregressive(double rho, std::size_t n, std::mt19937_64& engine) {
    std::vector<double> x = test::normal_sample(n, engine);
    for (std::size_t i = 1; i < n; ++i) x[i] = rho * x[i - 1] + std::sqrt(1 - rho * rho) * x[i];
    return x;
}

TEST(SerialTest, KeepsItsFalseAlarmRate) {
    std::mt19937_64 engine(1);
    for (const std::size_t n : {12u, 60u, 400u}) {
        const auto alarms =
            test::count_events(4000, [&] { return test_serial_correlation(test::normal_sample(n, engine))->p < 0.05; });
        EXPECT_TRUE(test::has_probability_at_most(alarms, 4000, 0.055, {.alpha = 1e-4, .detects = 0.03})) << n;
    }
}

TEST(SerialTest, HoldsForSkewedValues) {
    std::mt19937_64 engine(2);
    const auto alarms = test::count_events(4000, [&] {
        return test_serial_correlation(test::sample(std::exponential_distribution<double>(1), 100, engine))->p < 0.05;
    });
    EXPECT_TRUE(test::has_probability_at_most(alarms, 4000, 0.055, {.alpha = 1e-4, .detects = 0.03}));
}

// Chi-squared tails are far off for values that are nearly all equal: by them, 4 % of these series have p < 1e-3.
// Risks: false alarm 1e-4; .01 is noticed with power .99.
TEST(SerialTest, HoldsInTheFarTailForRareValues) {
    std::mt19937_64 engine(5);
    std::bernoulli_distribution rare(0.02);
    const auto alarms = test::count_events(2000, [&] {
        std::vector<double> values(200);
        for (double& value : values) value = rare(engine) ? 1 : 0;
        const auto found = test_serial_correlation(values);
        return found && found->p < 1e-3;
    });
    EXPECT_TRUE(test::has_probability_at_most(alarms, 2000, 1e-3, {.alpha = 1e-4, .detects = 0.01}));
}

TEST(SerialTest, FindsTheStatedDetectableCorrelation) {
    std::mt19937_64 engine(3);
    constexpr std::size_t n = 200;
    const std::uint64_t series = test::repetitions(120, 1000);
    const auto found = test::count_events(series, [&] {
        const std::vector<double> quiet = test::normal_sample(n, engine);
        const double rho = test_serial_correlation(quiet)->detectable;
        return test_serial_correlation(autoregressive(rho, n, engine))->p < 0.05;
    });
    EXPECT_TRUE(test::has_probability_at_least(found, series, 0.9,
                                               {.alpha = 1e-4, .detects = test::is_nightly() ? 0.065 : 0.22}));
}

TEST(SerialTest, FindsAPeriodOfFiveValues) {
    std::mt19937_64 engine(4);
    std::vector<double> values = test::normal_sample(200, engine);
    for (std::size_t i = 5; i < values.size(); ++i) values[i] += values[i - 5];
    EXPECT_LT(test_serial_correlation(values)->p, 1e-6);
}

TEST(SerialTest, IsEmptyForFewOrEqualValues) {
    EXPECT_FALSE(test_serial_correlation(std::vector<double>{1, 2, 3}));
    EXPECT_FALSE(test_serial_correlation(std::vector<double>(20, 1.0)));
}

TEST(AutocorrelationTime, MatchesTheoryForAnAutoregressiveSeries) {
    // (1 + rho) / (1 - rho) = 3 and 9. Its own error is some 5 % at this length.
    std::mt19937_64 engine(5);
    EXPECT_NEAR(autocorrelation_of(autoregressive(0.5, 100'000, engine)).time, 3, 0.3);
    EXPECT_NEAR(autocorrelation_of(autoregressive(0.8, 100'000, engine)).time, 9, 1.5);
}

TEST(AutocorrelationTime, IsNearlyOneForIndependentValuesAndNeverLess) {
    std::mt19937_64 engine(6);
    EXPECT_NEAR(autocorrelation_of(test::normal_sample(100'000, engine)).time, 1, 0.05);
    EXPECT_EQ(autocorrelation_of(autoregressive(-0.6, 10'000, engine)).time, 1);
}

}  // namespace
}  // namespace ff::stats

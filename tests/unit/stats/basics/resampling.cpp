#include "stats/basics/resampling.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/goodness_of_fit/chi_squared.hpp"
#include "tests/support/kolmogorov.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ff::stats {
namespace {

constexpr StreamKey draws_key{.word0 = 11, .word1 = 12};

TEST(Draws, DependOnKeyUseAndReplicateOnly) {
    const auto first = [](StreamKey k, Resampling use, std::uint32_t replicate) {
        return Draws(k, use, replicate).uniform();
    };
    EXPECT_EQ(first(draws_key, Resampling::bootstrap, 3), first(draws_key, Resampling::bootstrap, 3));
    EXPECT_NE(first(draws_key, Resampling::bootstrap, 3), first(draws_key, Resampling::bootstrap, 4));
    EXPECT_NE(first(draws_key, Resampling::bootstrap, 3), first(draws_key, Resampling::simulation, 3));
    EXPECT_NE(first(draws_key, Resampling::bootstrap, 3), first({}, Resampling::bootstrap, 3));
}

// Fixed seed; a false alarm had probability 1e-6.
TEST(Draws, AreUniform) {
    Draws draws(draws_key, Resampling::jitter, 0);
    std::vector<double> values(1000);
    for (double& value : values) value = draws.uniform();
    EXPECT_GT(test::test_uniformity(values)->p, 1e-6);
    for (double& value : values) value *= 0.8;  // the check notices this
    EXPECT_LT(test::test_uniformity(values)->p, 1e-6);
}

TEST(Draws, AreUniformBelowABoundWhereModuloWouldNotBe) {
    Draws draws(draws_key, Resampling::simulation, 0);
    const std::size_t n = std::size_t{3} << 30;  // word % n would hit the lowest third twice as often
    std::array<std::uint64_t, 3> thirds{};
    for (int i = 0; i < 3000; ++i) ++thirds[draws.below(n) / (n / 3)];
    const std::array probabilities{1.0 / 3, 1.0 / 3, 1.0 / 3};
    EXPECT_GT(test_goodness_of_fit(thirds, probabilities)->chi_squared.p, 1e-6);
    EXPECT_EQ(draws.below(1), 0u);
}

TEST(Resample, DrawsOnlyGivenValues) {
    const std::array data{1.0, 2.0, 3.0};
    std::vector<double> sample(100);
    Draws draws(draws_key, Resampling::bootstrap, 0);
    resample(data, draws, sample);
    for (const double value : data) EXPECT_GT(std::count(sample.begin(), sample.end(), value), 10);
    EXPECT_EQ(std::count(sample.begin(), sample.end(), 1) + std::count(sample.begin(), sample.end(), 2) +
                  std::count(sample.begin(), sample.end(), 3),
              100);
}

// Student's t of 20 normal values exceeds 2.861 in .005 of samples. The check is exact up to the pool's own error.
TEST(ResampledT, IsStudentsTForNormalValuesAndSkewedForSkewedOnes) {
    Draws draws(draws_key, Resampling::simulation, 1);
    std::vector<double> normal(20'000);
    std::vector<double> skewed(20'000);
    for (double& value : normal) value = normal_critical(1 - draws.uniform());
    for (double& value : skewed) value = -std::log(1 - draws.uniform());
    const auto beyond = [](const std::vector<double>& found, double t) {
        return static_cast<std::uint64_t>(std::count_if(found.begin(), found.end(), [t](double x) { return x >= t; }));
    };
    const auto even = resampled_t(normal, 20, 40'000, draws_key);
    EXPECT_TRUE(test::has_probability(beyond(even, 2.861), even.size(), 0.005, {.alpha = 1e-6, .detects = 0.003}));
    const auto leaning = resampled_t(skewed, 20, 40'000, draws_key);
    EXPECT_LT(beyond(leaning, 2.861), 40u);
    EXPECT_EQ(resampled_t(std::vector<double>{1, 1}, 5, 10, draws_key).size(), 0u);
}

}  // namespace
}  // namespace ff::stats

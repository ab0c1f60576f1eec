#include "studies/analysis/summary.hpp"

#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ff::studies {
namespace {

/// Quantiles of the normal distribution: as normal as n values can be.
std::vector<double> normal_values(std::size_t n, double mean, double sigma) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) {
        values.push_back(mean -
                         sigma * stats::normal_critical((static_cast<double>(i) + 0.5) / static_cast<double>(n)));
    }
    return values;
}

std::uint64_t runs_of(const ErrorShape& shape) {
    return std::accumulate(shape.bins.begin(), shape.bins.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const auto& bin) { return sum + bin.runs; });
}

TEST(ErrorShape, CountsEveryRunOnce) {
    const auto shape = error_shape(normal_values(1000, 0.2, 0.01), 0.19, std::nullopt);
    ASSERT_TRUE(shape);
    EXPECT_EQ(runs_of(*shape), 1000u);
    EXPECT_NEAR(shape->mean, 0.01, 1e-6);
    EXPECT_NEAR(shape->sigma, 0.01, 1e-4);
    EXPECT_NEAR(shape->q75 - shape->mean, 0.6745 * 0.01, 1e-4);
}

TEST(ErrorShape, FollowsTheCurveAndTheLineForNormalRuns) {
    const auto shape = error_shape(normal_values(1000, 0, 1), 0, std::nullopt);
    ASSERT_TRUE(shape);
    for (const auto& bin : shape->bins) EXPECT_NEAR(static_cast<double>(bin.runs), bin.normal, 3);
    for (const auto& q : shape->quantiles) EXPECT_NEAR(q.runs, q.normal, 0.02);
}

TEST(ErrorShape, DepartsFromTheLineForSkewedRuns) {
    std::vector<double> values;
    for (const double z : normal_values(1000, 0, 1)) values.push_back(std::exp(z));
    const auto shape = error_shape(values, 0, std::nullopt);
    ASSERT_TRUE(shape);
    EXPECT_GT(std::abs(shape->quantiles.front().runs - shape->quantiles.front().normal), 0.5);
}

TEST(ErrorShape, BinsWholeStepsOfALattice) {
    std::vector<double> values;
    for (int i = 0; i < 400; ++i) values.push_back(0.25 * (i % 20));
    const auto shape = error_shape(values, 0, 0.25);
    ASSERT_TRUE(shape);
    EXPECT_EQ(runs_of(*shape), 400u);
    for (const auto& bin : shape->bins) {
        const double steps = (bin.high - bin.low) / 0.25;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_EQ(bin.runs, static_cast<std::uint64_t>(20 * std::lround(steps))) << bin.low;
    }
}

TEST(ErrorShape, IsEmptyForFewOrEqualValues) {
    EXPECT_FALSE(error_shape(normal_values(19, 0, 1), 0, std::nullopt));
    EXPECT_FALSE(error_shape(std::vector<double>(100, 0.2), 0, std::nullopt));
}

}  // namespace
}  // namespace ff::studies

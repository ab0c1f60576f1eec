#include "stats/skewed_mean.hpp"

#include "stats/distributions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

SkewedReach reach(const std::vector<double>& values, double tail) {
    const auto n = static_cast<double>(values.size());
    return reach_of_mean(values, n, n - 1, tail);
}

std::vector<double> exponential(std::size_t n) {
    std::vector<double> values;  // quantiles, so that nothing is left to chance
    for (std::size_t i = 0; i < n; ++i)
        values.push_back(-std::log1p(-(static_cast<double>(i) + 0.5) / static_cast<double>(n)));
    return values;
}

TEST(ReachOfMean, IsNearlyStudentsForManySymmetricValues) {
    std::mt19937_64 engine(1);
    const auto found = reach(test::normal_sample(100'000, engine), 5e-5);
    const double t = student_critical(99'999, 5e-5);
    EXPECT_GE(found.below, t);
    EXPECT_GE(found.above, t);
    // Three standard errors of the skewness and its own: 0.05 z^2 / (3 sqrt n).
    EXPECT_LT(std::max(found.below, found.above), 1.003 * t);
    EXPECT_FALSE(found.below_is_open || found.above_is_open);
}

TEST(ReachOfMean, IsLongerTowardsALongTail) {
    for (const double sign : {1.0, -1.0}) {
        std::vector<double> values = exponential(200);
        for (double& value : values) value *= sign;
        const auto found = reach(values, 5e-5);
        const double towards = sign > 0 ? found.above : found.below;
        const double away = sign > 0 ? found.below : found.above;
        EXPECT_GT(towards, 1.2 * away);
    }
}

TEST(ReachOfMean, DoesNotDependOnUnitAndOrigin) {
    std::vector<double> values = exponential(50);
    const auto found = reach(values, 1e-3);
    for (double& value : values) value = 1e-60 * (value + 0.25);
    const auto scaled = reach(values, 1e-3);
    EXPECT_NEAR(scaled.above, found.above, 1e-9 * found.above);
    EXPECT_NEAR(scaled.below, found.below, 1e-9 * found.below);
}

TEST(ReachOfMean, IsOpenForFewSkewedValuesAtSmallTails) {
    EXPECT_TRUE(reach(exponential(40), 5e-5).above_is_open);
    EXPECT_FALSE(reach(exponential(40), 5e-5).below_is_open);
    EXPECT_FALSE(reach(exponential(40), 0.05).above_is_open);
    EXPECT_FALSE(reach(exponential(4000), 5e-5).above_is_open);
}

TEST(ReachOfMean, IsOpenOnBothSidesBelowThirtyValues) {
    std::mt19937_64 engine(2);
    const auto found = reach(test::normal_sample(20, engine), 5e-5);
    EXPECT_TRUE(found.below_is_open && found.above_is_open);
}

}  // namespace
}  // namespace ff::stats

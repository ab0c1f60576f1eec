#include "stats/means/mean_test.hpp"

#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace ff::stats {
namespace {

/// A mean of 2 with a standard error of 0.1 from values without skewness.
MeanEvidence known_mean(double standard_error = 0.1) {
    return {.difference = 2,
            .standard_error = standard_error,
            .freedom = 99,
            .skewness = {.most = no_part},
            .method = {},
            .n = 100};
}

TEST(Measured, ReachesToTheLogarithmOfTheLimitOfItsMean) {
    const Measured logarithm = logarithm_of(known_mean(), 3);
    const double t = student_critical(99, 0.025);
    EXPECT_DOUBLE_EQ(logarithm.value, std::log(6));
    EXPECT_NEAR(logarithm.reach(1, 0.025), std::log1p(0.05 * t), 1e-15);
    EXPECT_NEAR(logarithm.reach(-1, 0.025), -std::log1p(-0.05 * t), 1e-15);
}

TEST(Measured, ReachesDownInProportionForMeansNear0) {
    const double t = student_critical(99, 0.025);
    EXPECT_NEAR(logarithm_of(known_mean(0.9)).reach(-1, 0.025), 2 * 0.45 * t, 1e-12);
    EXPECT_NEAR(logarithm_of(known_mean(5)).reach(-1, 0.025), 2 * 2.5 * t, 1e-12);
}

// Values that no evaluation has met can only increase a mean square.
TEST(Measured, ReachesHigherWhereEvaluationsMayHaveMissedSomething) {
    MeanEvidence mean = known_mean();
    mean.unmet = {.largest = 1, .evaluations = 100};
    const double t = student_critical(99, 0.9 * 0.025);
    EXPECT_NEAR(logarithm_of(mean).reach(1, 0.025), std::log1p(0.05 * t + mean.unmet.reach(0.1 * 0.025) / 2), 1e-14);
    EXPECT_NEAR(logarithm_of(mean).reach(-1, 0.025), -std::log1p(-0.05 * t), 1e-14);
}

TEST(Measured, AddsReachesInQuadratureAndSwapsThoseOfNegativeParts) {
    Measured sum = logarithm_of(known_mean());
    sum.parts.push_back(sum.parts.front());
    sum.parts.back().weight = -0.5;
    const Measured one = logarithm_of(known_mean());
    EXPECT_NEAR(sum.reach(1, 0.01), std::hypot(one.reach(1, 0.01), 0.5 * one.reach(-1, 0.01)), 1e-14);
}

TEST(Measured, HasAnIntervalOfTheDifferenceUnlessBothAreExact) {
    const Measured first = with_error(1, 0.3, 50);
    const Measured second = with_error(2, 0.4, 50);
    const auto interval = difference_interval(first, second, 0.95);
    EXPECT_NEAR(interval->width() / 2, 0.5 * student_critical(49, 0.025), 1e-12);
    EXPECT_NEAR(interval->low + interval->high, 2, 1e-12);
    EXPECT_LT(difference_interval(first, second, 0.95, 0.9)->width(), interval->width());
    EXPECT_FALSE(difference_interval({1, {}}, {2, {}}, 0.95));
    EXPECT_EQ(p_of_equal({1, {}}, {2, {}}), 0);
    EXPECT_NEAR(p_of_equal(first, second), student_two_sided_p(2, 49), 1e-6);
}

TEST(Measured, ReachesToInfinityForFewSkewedTrials) {
    const std::array values{1.0, 1.1, 0.9, 1.0, 5.0, 1.2};
    const Measured skewed = logarithm_of(*mean_evidence(values, 0));
    EXPECT_EQ(skewed.reach(1, 1e-4), std::numeric_limits<double>::infinity());
    EXPECT_EQ(difference_interval({0, {}}, skewed, 0.999)->high, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ff::stats

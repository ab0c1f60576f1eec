#include "stats/goodness_of_fit/discrepancy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::stats {
namespace {

// For one point x in one dimension, the integral of (1[x < t] - t)^2 over t is x^3 / 3 + (1 - x)^3 / 3.
TEST(Discrepancy, MatchesTheIntegralForOnePoint) {
    for (const double x : {0.0, 0.25, 0.5, 0.9}) {
        const double integral = (x * x * x + (1 - x) * (1 - x) * (1 - x)) / 3;
        EXPECT_NEAR(l2_star_discrepancy({{x}}), std::sqrt(integral), 1e-15);
    }
}

// The n midpoints of an axis have the least of both: 1 / (12 n^2) is its square.
TEST(Discrepancy, IsSmallestForMidpointsOnAnAxis) {
    constexpr std::size_t n = 10;
    Coordinates points(1);
    for (std::size_t i = 0; i < n; ++i) points[0].push_back((static_cast<double>(i) + 0.5) / n);
    EXPECT_NEAR(l2_star_discrepancy(points), 1 / (std::sqrt(12.0) * n), 1e-12);
    EXPECT_NEAR(centred_discrepancy(points), 1 / (std::sqrt(12.0) * n), 1e-12);
    points[0][3] += 0.01;
    EXPECT_GT(l2_star_discrepancy(points), 1 / (std::sqrt(12.0) * n) + 1e-5);
}

TEST(Discrepancy, OnlyTheCentredOneIsInvariantUnderReflection) {
    const Coordinates points{{0.1, 0.3, 0.8}, {0.7, 0.2, 0.4}};
    const Coordinates mirrored{{0.9, 0.7, 0.2}, {0.7, 0.2, 0.4}};
    EXPECT_NEAR(centred_discrepancy(points), centred_discrepancy(mirrored), 1e-15);
    EXPECT_GT(std::abs(l2_star_discrepancy(points) - l2_star_discrepancy(mirrored)), 0.01);
}

TEST(LargestGap, WrapsAroundTheEnds) {
    EXPECT_DOUBLE_EQ(largest_gap(std::vector{0.25}), 1.0);
    EXPECT_DOUBLE_EQ(largest_gap(std::vector{0.5, 0.25}), 0.75);
    EXPECT_DOUBLE_EQ(largest_gap(std::vector{0.0, 0.75, 0.125}), 0.625);
}

}  // namespace
}  // namespace ff::stats

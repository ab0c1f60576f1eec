#include "stats/means/box_distance.hpp"

#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

using Numbers = std::vector<double>;

TEST(DistanceToBox, IsTheMahalanobisDistanceToAPoint) {
    // (1, 0) C^-1 (1, 0)' with C = {{1, r}, {r, 1}}: 1 / (1 - r^2).
    const Numbers covariance{1, 0.6, 0.6, 1};
    EXPECT_NEAR(distance_to_box(Numbers{1, 0}, Numbers{0, 0}, Numbers{0, 0}, covariance).value(), 1 / 0.64, 1e-12);
}

TEST(DistanceToBox, UsesTheNearestPointInTheMetricOfTheCovariance) {
    // The second coordinate is free: the nearest point has y = r x, at a distance of 1, and not y = 0.
    const Numbers covariance{1, 0.6, 0.6, 1};
    EXPECT_NEAR(distance_to_box(Numbers{1, 0}, Numbers{0, -9}, Numbers{0, 9}, covariance).value(), 1, 1e-8);
    EXPECT_EQ(distance_to_box(Numbers{1, 0}, Numbers{0, -9}, Numbers{2, 9}, covariance).value(), 0);
}

TEST(DistanceToBox, DoesNotDependOnUnits) {
    const Numbers of_units{1e-40, 0.6e10, 0.6e10, 1e60};
    EXPECT_NEAR(distance_to_box(Numbers{3e-20, 0}, Numbers{0, 0}, Numbers{1e-20, 1e30}, of_units).value(),
                distance_to_box(Numbers{3, 0}, Numbers{0, 0}, Numbers{1, 1}, Numbers{1, 0.6, 0.6, 1}).value(), 1e-8);
}

TEST(DistanceToBox, IsEmptyWithoutAPositiveDefiniteCovariance) {
    const Numbers zero(2);
    EXPECT_FALSE(distance_to_box(zero, zero, zero, Numbers{1, 1, 1, 1}));
    EXPECT_FALSE(distance_to_box(zero, zero, zero, Numbers{1, 2, 2, 1}));
    EXPECT_FALSE(distance_to_box(zero, zero, zero, Numbers{1, 0, 0, 0}));
}

/// Correlated like a walk: entry min(i, j).
Numbers walk_covariance(std::size_t size) {
    Numbers covariance;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) covariance.push_back(static_cast<double>(std::min(i, j) + 1));
    }
    return covariance;
}

/// x, the end of a walk in a box of `band`, whose true mean is at a corner; how often chi-squared at 0.01 rejects.
int rejections_outside_box(double band, double shift) {
    constexpr std::size_t size = 12;
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    const Numbers covariance = walk_covariance(size);
    int count = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        Numbers x;
        double walk = 0;
        for (std::size_t i = 0; i < size; ++i) x.push_back((walk += normal(engine)) + (i % 2 == 0 ? shift : -shift));
        const double distance = distance_to_box(x, Numbers(size, -band), Numbers(size, band), covariance).value();
        count += chi_squared_tail(distance, size) < 0.01 ? 1 : 0;
    }
    return count;
}

// 2000 trials: more than 39 rejections have a probability of 1e-4 at a rate of 0.01; power: a rate of 0.03 has 0.9999.
TEST(DistanceToBox, KeepsTheLevelOfATestAtAPointAndAtACornerOfTheBox) {
    EXPECT_LE(rejections_outside_box(0, 0), 39);
    EXPECT_GE(rejections_outside_box(0, 0), 6);  // and is no smaller there
    EXPECT_LE(rejections_outside_box(0.5, 0.5), 39);
}

TEST(DistanceToBox, DetectsPointsOutsideTheBox) {
    EXPECT_GE(rejections_outside_box(0.1, 1.5), 1900);
}

}  // namespace
}  // namespace ff::stats

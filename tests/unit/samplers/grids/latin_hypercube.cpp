#include "samplers/grids/latin_hypercube.hpp"

#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace ff::samplers {
namespace {

/// The slice of each point, one coordinate a row.
std::array<std::vector<std::uint64_t>, max_dimension> slices(std::uint64_t points, const Stream& stream) {
    std::array<std::vector<std::uint64_t>, max_dimension> result;
    PointBlock block;
    for (PointIndex first = 0; first < points; first += block.size) {
        block.size = std::min<std::size_t>(block_capacity, points - first);
        LatinHypercube({.points = points}).fill(stream, first, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) {
                // The middle of the 2^-32 cell: where a slice begins within it, the cell belongs to either.
                result[d].push_back((block.coordinate[d][i] * points + points / 2) >> 32);
            }
        }
    }
    return result;
}

TEST(LatinHypercube, HasOnePointInEachSliceOfEachCoordinate) {
    for (const std::uint64_t points : {1u, 2u, 3u, 17u, 625u, 1024u, 1025u, 2401u, 10000u, 65536u}) {
        for (auto& row : slices(points, {.key = {2, 6}})) {
            std::sort(row.begin(), row.end());
            for (std::uint64_t i = 0; i < points; ++i) EXPECT_EQ(row[i], i);
        }
    }
}

TEST(LatinHypercube, DrawsEveryOrderOfThreeSlicesEquallyOften) {
    // 6 orders, 12000 streams a coordinate: chi-squared with 5 degrees of freedom exceeds 43.9 with probability 2.4e-8
    // (4 tests: 1e-7), and probabilities that are off by 8 % (root mean square) are noticed nearly always (12000 *
    // .0064 = 77).
    constexpr std::uint32_t streams = 12000;
    std::array<std::map<std::vector<std::uint64_t>, double>, max_dimension> counts;
    for (std::uint32_t trial = 0; trial < streams; ++trial) {
        const auto rows = slices(3, {.key = {1, 5}, .trial = trial});
        for (std::size_t d = 0; d < max_dimension; ++d) ++counts[d][rows[d]];
    }
    for (const auto& orders : counts) {
        ASSERT_EQ(orders.size(), 6u);
        double statistic = 0;
        for (const auto& [order, count] : orders)
            statistic += (count - streams / 6.0) * (count - streams / 6.0) / (streams / 6.0);
        EXPECT_LT(statistic, 43.9);
    }
}

/// Chi-squared of the slices of two points of large sets, on a grid of 5 x 5 (24 degrees of freedom): more than 83 with
/// probability 2e-8; 2000 streams notice a deviation of 25 % (root mean square) nearly always (2000 * .0625 = 125).
double statistic_of_two(std::uint64_t points, PointIndex a, PointIndex b) {
    constexpr std::uint32_t streams = 2000;
    std::array<double, 25> counts{};
    for (std::uint32_t trial = 0; trial < streams; ++trial) {
        const auto slice = [&](PointIndex i) {
            PointBlock block;
            block.size = 1;
            LatinHypercube({.points = points}).fill({.key = {3, 5}, .trial = trial}, i, block);
            return block.coordinate[1][0] * 5ull >> 32;
        };
        ++counts[slice(a) * 5 + slice(b)];
    }
    double statistic = 0;
    for (const double count : counts)
        statistic += (count - streams / 25.0) * (count - streams / 25.0) / (streams / 25.0);
    return statistic;
}

TEST(LatinHypercube, OrdersLargeSetsAtRandom) {
    for (const PointIndex b : {PointIndex{1}, PointIndex{64}, PointIndex{1200}, PointIndex{2400}}) {
        EXPECT_LT(statistic_of_two(2401, 0, b), 83);
    }
    // A point and itself are not independent, and the check notices.
    EXPECT_GT(statistic_of_two(2401, 7, 7), 83);
}

/// Squared errors of the mean over `points` points of a function whose integral is 0.
template <class Function>
std::vector<double> squared_errors(std::size_t points, std::uint32_t trials, Function function) {
    std::vector<double> squares;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        double sum = 0;
        PointBlock block;
        for (PointIndex first = 0; first < points; first += block.size) {
            block.size = std::min<std::size_t>(block_capacity, points - first);
            LatinHypercube({.points = points}).fill({.key = {8, 5}, .trial = trial}, first, block);
            for (std::size_t i = 0; i < block.size; ++i) {
                sum += function([&](std::size_t d) { return (block.coordinate[d][i] + 0.5) * 0x1p-32 - 0.5; });
            }
        }
        squares.push_back(sum / static_cast<double>(points) * sum / static_cast<double>(points));
    }
    return squares;
}

TEST(LatinHypercube, HasTheVarianceThatFollowsFromItsDefinition) {
    // A sum of coordinates: in each of four, only the places within N slices vary, 4 / (12 N^3). A product of two: 1 /
    // 144 for each point, and between two points the square of the covariance of two slices, -(N + 1) / (12 N^2). Four
    // points are shuffled, 1100 take their order from a bijection. An error of 20 % is noticed with probability 0.99;
    // the second part of the product's variance is 29 % of the first for four points.
    for (const std::size_t points : {4u, 1100u}) {
        const std::uint32_t trials = points == 4 ? 20000 : 4000;
        const auto n = static_cast<double>(points);
        const double of_sum = 1 / (3 * n * n * n);
        const double between = (n + 1) / (12 * n * n);
        const double of_product = (1.0 / 144 + (n - 1) * between * between) / n;
        const auto sums = squared_errors(points, trials, [](auto x) { return x(0) + x(1) + x(2) + x(3); });
        const auto products = squared_errors(points, trials, [](auto x) { return x(0) * x(3); });
        EXPECT_TRUE(test::unbiased(sums, of_sum, {.alpha = 1e-6, .detects = 0.2 * of_sum})) << points;
        EXPECT_TRUE(test::unbiased(products, of_product, {.alpha = 1e-6, .detects = 0.2 * of_product})) << points;
    }
}

TEST(LatinHypercube, ReachesTheLastPointOfTheLargestSet) {
    PointBlock block;
    block.size = 2;
    LatinHypercube({.points = max_points}).fill({.key = {1, 1}}, max_points - 2, block);
    for (std::size_t d = 0; d < max_dimension; ++d) EXPECT_NE(block.coordinate[d][0], block.coordinate[d][1]);
}

}  // namespace
}  // namespace ff::samplers

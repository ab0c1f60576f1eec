#include "samplers/r_sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ff::samplers {
namespace {

PointBlock points_of(const Stream& stream, std::size_t dimension, PointIndex first, std::size_t size) {
    PointBlock block;
    block.dimension = dimension;
    block.size = size;
    RSequence({.points = first + size, .dimension = dimension}).fill(stream, first, block);
    return block;
}

TEST(RSequence, StepsByPowersOfTheGeneralisedGoldenRatio) {
    // x^(D+1) = x + 1, by Newton's method.
    for (std::size_t dimension = 1; dimension <= max_dimension; ++dimension) {
        const auto power = static_cast<double>(dimension + 1);
        double g = 1.5;
        for (int i = 0; i < 50; ++i) g -= (std::pow(g, power) - g - 1) / (power * std::pow(g, power - 1) - 1);
        const PointBlock block = points_of({.key = {1, 2}}, dimension, 0, 2);
        for (std::size_t d = 0; d < dimension; ++d) {
            const std::uint32_t step = block.coordinate[d][1] - block.coordinate[d][0];
            EXPECT_NEAR(step, std::pow(g, -static_cast<double>(d + 1)) * 0x1p32, 1.01);
        }
    }
}

TEST(RSequence, HasGapsOfThreeLengthsAtMostInEachCoordinate) {
    // The three-gap theorem for multiples of any number; the lengths are told apart to some 2^-32.
    const PointBlock block = points_of({.key = {1, 2}, .trial = 9}, 4, 0, 625);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        std::vector<std::uint32_t> sorted(block.coordinate[d].begin(), block.coordinate[d].begin() + 625);
        std::sort(sorted.begin(), sorted.end());
        std::set<std::uint32_t> lengths;
        for (std::size_t i = 0; i < 625; ++i) lengths.insert((sorted[(i + 1) % 625] - sorted[i] + 8) / 16);
        EXPECT_LE(lengths.size(), 4u);  // rounding may split one
        EXPECT_GE(lengths.size(), 2u);
    }
}

TEST(RSequence, StaysExactAtTheEndOfTheLongestSet) {
    const Stream stream{.key = {1, 2}};
    const PointBlock start = points_of(stream, 1, 0, 1);
    const PointBlock end = points_of(stream, 1, max_points - 1, 1);
    // python3 -c "print(((2**32 - 1) * 0x9e3779b97f4a7c15 >> 32) % 2**32)": 0x7f4a7c14 less 0x9e3779b9, and so on
    const std::uint32_t moved = end.coordinate[0][0] - start.coordinate[0][0];
    EXPECT_NEAR(moved, 0xe113025bu, 1);
}

}  // namespace
}  // namespace ff::samplers

#include "samplers/sequences/r_sequence.hpp"

#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ff::samplers {
namespace {

PointBlock r_sequence_points(const Stream& stream, std::size_t dimension, PointIndex first, std::size_t size) {
    return test::block_of(RSequence({.points = first + size, .dimension = dimension}), stream, first, size, dimension);
}

TEST(RSequence, StepsByPowersOfTheGeneralisedGoldenRatio) {
    // The ratios for one to four dimensions as published [roberts2018], and the recipe there: fractions of s + i / g^d.
    constexpr std::array<long double, 4> ratios{1.61803398874989484820L, 1.32471795724474602596L,
                                                1.22074408460575947536L, 1.16730397826141868425L};
    for (std::size_t dimension = 1; dimension <= max_dimension; ++dimension) {
        const PointBlock block = r_sequence_points({.key = {1, 2}}, dimension, 0, 1000);
        for (std::size_t d = 0; d < dimension; ++d) {
            const long double step = std::pow(ratios[dimension - 1], -static_cast<long double>(d + 1));
            for (std::uint32_t i = 0; i < 1000; ++i) {
                const std::uint32_t moved = block.coordinate[d][i] - block.coordinate[d][0];
                EXPECT_NEAR(moved, static_cast<double>(std::fmod(i * step, 1.0L) * 0x1p32L), 1.01);
            }
        }
    }
}

TEST(RSequence, HasGapsOfThreeLengthsAtMostInEachCoordinate) {
    // The three-gap theorem for multiples of any number; lengths are distinguished to some 2^-32.
    const PointBlock block = r_sequence_points({.key = {1, 2}, .trial = 9}, 4, 0, 625);
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
    const PointBlock start = r_sequence_points(stream, 1, 0, 1);
    const PointBlock end = r_sequence_points(stream, 1, max_points - 1, 1);
    // python3 -c "print(((2**32 - 1) * 0x9e3779b97f4a7c15 >> 32) % 2**32)": 0x7f4a7c14 less 0x9e3779b9, and so on
    const std::uint32_t moved = end.coordinate[0][0] - start.coordinate[0][0];
    EXPECT_NEAR(moved, 0xe113025bu, 1);
}

}  // namespace
}  // namespace ff::samplers

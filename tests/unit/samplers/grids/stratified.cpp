#include "samplers/grids/stratified.hpp"

#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

PointBlock stratified_points(std::uint64_t points, std::size_t dimension, PointIndex first, std::size_t size) {
    return test::block_of(Stratified({.points = points, .dimension = dimension}), {.key = {9, 9}}, first, size,
                          dimension);
}

std::uint64_t cell(std::uint32_t x, std::uint64_t cells) {
    return x * cells >> 32;
}

TEST(Stratified, CountsCellsWithTheFirstCoordinateFastest) {
    const PointBlock block = stratified_points(625, 4, 0, 625);
    for (std::size_t i = 0; i < 625; ++i) {
        EXPECT_EQ(cell(block.coordinate[0][i], 5), i % 5);
        EXPECT_EQ(cell(block.coordinate[1][i], 5), i / 5 % 5);
        EXPECT_EQ(cell(block.coordinate[2][i], 5), i / 25 % 5);
        EXPECT_EQ(cell(block.coordinate[3][i], 5), i / 125);
    }
}

TEST(Stratified, KeepsThePlaceInTheCellThatPhiloxGives) {
    const Stream stream{.key = {9, 9}};
    const PointBlock block = stratified_points(625, 4, 0, 625);
    for (std::uint32_t i = 0; i < 625; ++i) {
        const Words words = philox(stream, i, Purpose::coordinates);
        const double inside = block.coordinate[2][i] * 5.0 - (i / 25 % 5) * 0x1p32;
        EXPECT_NEAR(inside, words[2], 5);  // rounded down to a whole x
    }
}

TEST(Stratified, HasOneCellForOnePoint) {
    EXPECT_EQ(stratified_points(1, 4, 0, 1).coordinate[1][0], philox({.key = {9, 9}}, 0, Purpose::coordinates)[1]);
}

TEST(Stratified, ReachesTheLastCellsOfTheLargestSets) {
    const std::uint64_t points = std::uint64_t{1} << 32;
    for (std::size_t dimension = 1; dimension <= 4; dimension *= 2) {
        const PointBlock block = stratified_points(points, dimension, points - 1, 1);
        const std::uint64_t cells = std::uint64_t{1} << 32 / dimension;
        for (std::size_t d = 0; d < dimension; ++d) EXPECT_EQ(cell(block.coordinate[d][0], cells), cells - 1);
    }
}

}  // namespace
}  // namespace ff::samplers

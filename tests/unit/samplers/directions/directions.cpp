#include "samplers/directions/antithetic_directions.hpp"
#include "samplers/directions/isocell.hpp"
#include "samplers/directions/local_directions.hpp"
#include "samplers/sequences/hammersley.hpp"
#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace ff::samplers {
namespace {

constexpr Stream direction_stream{.key = {4, 4}, .trial = 2};

template <class Sampler>
PointBlock direction_points(std::uint64_t size, std::size_t dimension, PointIndex first = 0, std::size_t count = 0) {
    return test::block_of(Sampler({.points = size, .dimension = dimension}), direction_stream, first,
                          count == 0 ? size : count, dimension);
}

double unit(std::uint32_t x) {
    return x * 0x1p-32;
}

// k rings of equal width; of ring j (from 0) 3 (2 j + 1) cells of equal width.
TEST(Isocell, HasOneDirectionInEachCell) {
    for (const std::uint64_t k : {1u, 2u, 7u, 16u}) {
        const auto block = direction_points<Isocell>(3 * k * k, 4);
        std::set<std::pair<int, int>> seen;
        for (std::size_t i = 0; i < block.size; ++i) {
            const int ring = static_cast<int>(std::sqrt(unit(block.coordinate[2][i])) * static_cast<double>(k));
            seen.emplace(ring, static_cast<int>(unit(block.coordinate[3][i]) * 3 * (2 * ring + 1)));
        }
        EXPECT_EQ(seen.size(), 3 * k * k);
    }
}

TEST(Isocell, GivesThePointsOfASetInAnyPieces) {
    const auto whole = direction_points<Isocell>(300, 4);
    const auto part = direction_points<Isocell>(300, 4, 123, 50);
    for (std::size_t d = 0; d < 4; ++d) {
        for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(part.coordinate[d][i], whole.coordinate[d][123 + i]);
    }
}

TEST(Isocell, AcceptsSizesThatDoNotFillWholeRings) {
    for (const std::uint64_t size : {1u, 2u, 5u, 301u}) EXPECT_EQ(direction_points<Isocell>(size, 2).size, size);
}

// Each 64th of the grid's coordinate, shifted, holds one of 64 points, and so does each 64th of the base 2 coordinate.
// Both coordinates together are a net: each of 8 x 8 cells holds one point, except those that the shift cuts.
TEST(Hammersley, PairsAGridWithRadicalInverses) {
    const auto block = direction_points<Hammersley>(64, 4);
    std::vector<double> grid;
    std::set<int> slices;
    for (std::size_t i = 0; i < 64; ++i) {
        grid.push_back(unit(block.coordinate[2][i]));
        slices.insert(static_cast<int>(unit(block.coordinate[3][i]) * 64));
    }
    EXPECT_EQ(slices.size(), 64u);
    std::sort(grid.begin(), grid.end());
    for (std::size_t i = 1; i < 64; ++i) EXPECT_NEAR(grid[i] - grid[i - 1], 1.0 / 64, 1e-9);
}

TEST(Hammersley, GivesThePointsOfASetInAnyPieces) {
    for (const std::size_t dimension : {1u, 2u, 4u}) {
        const auto whole = direction_points<Hammersley>(1000, dimension);
        const auto part = direction_points<Hammersley>(1000, dimension, 900, 100);
        for (std::size_t d = 0; d < dimension; ++d) {
            for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(part.coordinate[d][i], whole.coordinate[d][900 + i]);
        }
    }
}

// 48 places with one direction in each of 12 cells: two rings of equal width, of 3 and 9 cells.
TEST(LocalDirections, HaveASetAtEachPlace) {
    const auto block = direction_points<LocalDirections<Isocell>>(576, 4);
    std::set<std::uint32_t> origins, azimuths;
    for (std::size_t place = 0; place < 48; ++place) {
        std::set<std::pair<int, int>> seen;
        for (std::size_t i = 12 * place; i < 12 * (place + 1); ++i) {
            for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(block.coordinate[d][i], block.coordinate[d][12 * place]);
            const int ring = static_cast<int>(std::sqrt(unit(block.coordinate[2][i])) * 2);
            seen.emplace(ring, static_cast<int>(unit(block.coordinate[3][i]) * 3 * (2 * ring + 1)));
        }
        EXPECT_EQ(seen.size(), 12u);
        origins.insert(block.coordinate[0][12 * place]);
        azimuths.insert(block.coordinate[3][12 * place]);
    }
    EXPECT_EQ(origins.size(), 48u);
    EXPECT_EQ(azimuths.size(), 48u);
}

TEST(LocalDirections, GiveThePointsOfASetInAnyPieces) {
    for (const std::size_t dimension : {1u, 2u, 4u}) {
        const auto whole = direction_points<LocalDirections<Hammersley>>(1000, dimension);
        const auto part = direction_points<LocalDirections<Hammersley>>(1000, dimension, 900, 100);
        for (std::size_t d = 0; d < dimension; ++d) {
            for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(part.coordinate[d][i], whole.coordinate[d][900 + i]);
        }
    }
}

TEST(AntitheticDirections, PairDirectionsHalfATurnApart) {
    for (const PointIndex first : {0u, 1u, 6u}) {
        const auto block = direction_points<AntitheticDirections>(200, 4, first, 100);
        for (std::size_t i = first % 2; i + 1 < block.size; i += 2) {
            for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(block.coordinate[d][i], block.coordinate[d][i + 1]);
            EXPECT_EQ(block.coordinate[3][i] ^ 0x80000000u, block.coordinate[3][i + 1]);
        }
    }
}

}  // namespace
}  // namespace ff::samplers

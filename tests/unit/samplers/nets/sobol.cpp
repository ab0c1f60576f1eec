#include "samplers/nets/sobol.hpp"

#include "samplers/nets/sobol_directions.hpp"
#include "samplers/support/owen_hash.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"
#include "tests/unit/samplers/nets/net.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace ff::samplers {
namespace {

constexpr Stream sobol_stream{.key = {3, 1}, .trial = 4, .source = 1, .target = 5};

/// 2^m points from `first` on.
test::Coordinates sobol_points(unsigned m, PointIndex first) {
    test::Coordinates points;
    PointBlock block;
    block.size = std::min(block_capacity, std::size_t{1} << m);
    for (PointIndex i = 0; i < PointIndex{1} << m; i += block.size) {
        Sobol({.points = 1u << m}).fill(sobol_stream, first + i, block);
        for (std::size_t d = 0; d < 4; ++d) {
            points[d].insert(points[d].end(), block.coordinate[d].begin(),
                             block.coordinate[d].begin() + static_cast<std::ptrdiff_t>(block.size));
        }
    }
    return points;
}

template <class Map>
test::Coordinates mapped(unsigned m, PointIndex first, Map map) {
    test::Coordinates points;
    for (PointIndex i = first; i < first + (PointIndex{1} << m); ++i) {
        for (std::size_t d = 0; d < 4; ++d)
            points[d].push_back(map(sobol_coordinate(static_cast<std::uint32_t>(i), d)));
    }
    return points;
}

TEST(SobolDirections, GiveTheFirstPointsOfJoeAndKuo) {
    // Points 1 to 4 in natural order, times 8, by hand from new-joe-kuo-6: m = (1), (1), (1, 3), (1, 3, 1).
    const std::array<std::array<std::uint32_t, 4>, 4> expected{
        {{4, 4, 4, 4}, {2, 6, 6, 6}, {6, 2, 2, 2}, {1, 5, 3, 1}}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (std::size_t d = 0; d < 4; ++d) EXPECT_EQ(sobol_coordinate(i + 1, d), expected[i][d] << 29) << i << d;
    }
}

TEST(Sobol, IsTheHashOfTheSobolSequenceWithEveryInstructionSet) {
    const Words addends = philox(sobol_stream, 0, Purpose::scramble);
    const Words multipliers = philox(sobol_stream, 1, Purpose::scramble);
    for (const PointIndex first : {PointIndex{0}, PointIndex{5}, PointIndex{0x7ffffff3}, PointIndex{0xfffffc00}}) {
        const auto sets = test::with_each_instruction_set([&] {
            PointBlock block;
            block.size = block_capacity;
            Sobol({.points = 1}).fill(sobol_stream, first, block);
            return block.coordinate;
        });
        for (const auto& coordinate : sets) EXPECT_EQ(coordinate, sets.front());
        for (std::size_t d = 0; d < 4; ++d) {
            for (std::uint32_t i = 0; i < block_capacity; ++i) {
                EXPECT_EQ(sets.front()[d][i], owen_scramble(sobol_coordinate(static_cast<std::uint32_t>(first) + i, d),
                                                            {addends[d], multipliers[d]}));
            }
        }
    }
}

TEST(Sobol, IsANetAndScramblingKeepsItsParameter) {
    for (unsigned m = 4; m <= 12; ++m) {
        for (const PointIndex first : {PointIndex{0}, PointIndex{3} << m}) {
            const unsigned t = test::net_parameter(mapped(m, first, [](std::uint32_t x) { return x; }), m);
            EXPECT_LE(t, 3u);  // the sum of (degree - 1) over the primitive polynomials of degree 1, 2 and 3
            EXPECT_EQ(test::net_parameter(sobol_points(m, first), m), t);
            RecordProperty("t_" + std::to_string(m) + "_" + std::to_string(first >> m), static_cast<int>(t));
        }
    }
}

TEST(NetParameter, CatchesTheFirstPointDropped) {
    EXPECT_GT(test::net_parameter(sobol_points(8, 1), 8), 3u);
}

TEST(NetParameter, CatchesDigitsShuffledFromTheWrongEnd) {
    // Without the reversals the hash keeps every coordinate stratified by itself; only the net is lost.
    const auto shuffled = mapped(8, 0, [](std::uint32_t x) { return owen_hash(x, {0x9e3779b9, 0x7f4a7c15}); });
    EXPECT_GT(test::net_parameter(shuffled, 8), 3u);
}

}  // namespace
}  // namespace ff::samplers

#include "samplers/nets/padded.hpp"

#include "samplers/nets/sobol_directions.hpp"
#include "samplers/support/owen_hash.hpp"
#include "tests/unit/samplers/blocks.hpp"
#include "tests/unit/samplers/nets/net.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ff::samplers {
namespace {

PointBlock padded_points(const Stream& stream, PointIndex first, std::size_t size) {
    return test::block_of(Padded({.points = first + size}), stream, first, size);
}

/// One point in each of 2^k x 2^(m-k) boxes, for every k.
bool is_perfect_net(const PointBlock& block, std::size_t a, std::size_t b, unsigned m) {
    for (unsigned k = 0; k <= m; ++k) {
        std::vector<bool> hit(std::size_t{1} << m, false);
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint64_t x = std::uint64_t{block.coordinate[a][i]} >> (32 - k);
            const std::uint64_t y = std::uint64_t{block.coordinate[b][i]} >> (32 - (m - k));
            hit[x << (m - k) | y] = true;
        }
        if (std::count(hit.begin(), hit.end(), false) != 0) return false;
    }
    return true;
}

TEST(Padded, IsAPerfectNetWithinEachPairButNotAcross) {
    for (unsigned m = 4; m <= 10; ++m) {
        const std::size_t size = std::size_t{1} << m;
        for (const PointIndex first : {PointIndex{0}, PointIndex{5} << m}) {
            const PointBlock block = padded_points({.key = {1, 9}, .trial = m}, first, size);
            EXPECT_TRUE(is_perfect_net(block, 0, 1, m));
            EXPECT_TRUE(is_perfect_net(block, 2, 3, m));
            EXPECT_FALSE(is_perfect_net(block, 0, 2, m));
            EXPECT_FALSE(is_perfect_net(block, 1, 3, m));
        }
    }
}

TEST(Padded, IsNotANetWithoutItsFirstPoint) {
    EXPECT_FALSE(is_perfect_net(padded_points({.key = {1, 9}}, 1, 256), 0, 1, 8));
}

TEST(Padded, IsTheScrambledSobolSequenceInShuffledOrder) {
    const Stream stream{.key = {7, 1}, .trial = 3};
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words multipliers = philox(stream, 1, Purpose::scramble);
    const Words orders = philox(stream, 2, Purpose::scramble);
    const PointBlock block = padded_points(stream, 0, 1024);
    for (std::uint32_t i = 0; i < 1024; ++i) {
        for (std::size_t d = 0; d < max_dimension; ++d) {
            const std::uint32_t index = owen_scramble(i, {orders[d / 2], orders[2 + d / 2]});
            EXPECT_EQ(block.coordinate[d][i],
                      owen_scramble(sobol_coordinate(index, d % 2), {addends[d], multipliers[d]}));
        }
    }
}

TEST(Padded, PairsPointsDifferentlyInEveryStream) {
    // Which of 16 points of the second pair comes with the first one: 2000 streams, 15 degrees of freedom, beyond 66
    // with probability 2e-8; a deviation of 25 % (root mean square) is noticed nearly always (2000 * .0625 = 125).
    constexpr std::uint32_t streams = 2000;
    std::array<double, 16> counts{};
    for (std::uint32_t trial = 0; trial < streams; ++trial) {
        const Stream stream{.key = {7, 1}, .trial = trial};
        const Words orders = philox(stream, 2, Purpose::scramble);
        const std::uint32_t first = owen_scramble(0, {orders[0], orders[2]});
        const std::uint32_t second = owen_scramble(0, {orders[1], orders[3]});
        ++counts[(first ^ second) & 15u];
    }
    double statistic = 0;
    for (const double count : counts)
        statistic += (count - streams / 16.0) * (count - streams / 16.0) / (streams / 16.0);
    EXPECT_LT(statistic, 66);
}

}  // namespace
}  // namespace ff::samplers

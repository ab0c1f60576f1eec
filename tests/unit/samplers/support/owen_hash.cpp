#include "samplers/support/owen_hash.hpp"

#include "core/points/stream.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ff::samplers {
namespace {

OwenSeed seed_of(std::uint32_t trial) {
    const Words words = philox({.key = {}, .trial = trial}, 0, Purpose::scramble);
    return {words[0], words[1]};
}

TEST(ReverseBits, IsItsOwnInverse) {
    EXPECT_EQ(reverse_bits(1), 0x80000000u);
    EXPECT_EQ(reverse_bits(0x12345678), 0x1e6a2c48u);  // python3 -c "print(hex(int(f'{0x12345678:032b}'[::-1], 2)))"
    EXPECT_EQ(reverse_bits(reverse_bits(0x9abcdef1)), 0x9abcdef1u);
}

TEST(OwenScramble, IsANestedPermutation) {
    // Below each of many random prefixes, changing lower digits changes no digit of the prefix or above, and flipping
    // the next digit flips that digit of the result: both together make it a permutation of every subinterval.
    for (std::uint32_t trial = 0; trial < 300; ++trial) {
        const OwenSeed seed = seed_of(trial);
        const Words words = philox({.key = {}, .trial = trial}, 1, Purpose::coordinates);
        for (unsigned depth = 0; depth < 32; ++depth) {
            const std::uint32_t digit = 0x80000000u >> depth;
            const std::uint32_t below = digit - 1;
            const std::uint32_t x = words[0];
            const std::uint32_t same_prefix = (x & ~below) | (words[1] & below);
            EXPECT_EQ(owen_scramble(x, seed) & ~below, owen_scramble(same_prefix, seed) & ~below);
            EXPECT_EQ((owen_scramble(x, seed) ^ owen_scramble(x ^ digit, seed)) & ~below, digit);
        }
    }
}

TEST(OwenScramble, PermutesAllIntervalsOfLength2ToTheMinus16) {
    std::vector<bool> hit(1u << 16, false);
    for (std::uint32_t i = 0; i < 1u << 16; ++i) hit[owen_scramble(i << 16, seed_of(1)) >> 16] = true;
    for (const bool interval : hit) EXPECT_TRUE(interval);
}

TEST(OwenScramble, IsExactlyUniformOverItsAddend) {
    // The same reasoning that makes it a permutation of x makes it one of the addend: on 16 digits, exhaustively.
    std::vector<bool> hit(1u << 16, false);
    for (std::uint32_t addend = 0; addend < 1u << 16; ++addend) {
        hit[owen_scramble(0xdeadbeef, {addend, 0x12345}) >> 16] = true;
    }
    for (const bool interval : hit) EXPECT_TRUE(interval);
}

}  // namespace
}  // namespace ff::samplers

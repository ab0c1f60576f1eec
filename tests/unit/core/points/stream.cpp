#include "core/points/stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

namespace ff {
namespace {

constexpr std::uint32_t all_ones = 0xffffffffu;

/// The counter of four words that `philox` makes of index, trial, source and (target, purpose).
Words philox_of_counter(const Words& counter, StreamKey key) {
    const Stream stream{.key = key, .trial = counter[1], .source = counter[2], .target = counter[3] >> 8};
    return philox(stream, counter[0], static_cast<Purpose>(counter[3] & 0xff));
}

// Philox4x32-10 in kat_vectors of the Random123 distribution.
TEST(Philox, GivesTheKnownAnswersOfRandom123) {
    EXPECT_EQ(philox_of_counter({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox_of_counter({all_ones, all_ones, all_ones, all_ones}, {all_ones, all_ones}),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox_of_counter({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, GivesOtherWordsForEveryPartOfTheAddress) {
    std::set<Words> seen;
    for (std::uint32_t bits = 0; bits < 128; ++bits) {
        const auto bit = [&](int k) { return bits >> k & 1u; };
        const Stream stream{.key = {bit(0), bit(1)}, .trial = bit(2), .source = bit(3), .target = bit(4)};
        seen.insert(philox(stream, bit(5), bit(6) != 0 ? Purpose::scramble : Purpose::coordinates));
    }
    EXPECT_EQ(seen.size(), 128u);
}

TEST(DeriveKey, IsAFunctionOfSeedAndText) {
    EXPECT_EQ(derive_key({42}, "box a=6 b=6 c=6"), derive_key({42}, std::string("box a=6 b=6 ") + "c=6"));
}

// If keys of 64 bits behave as random ones, any two of 2 * 10^4 keys collide with probability 1e-11.
TEST(DeriveKey, DiffersForDistinctTextsAndSeeds) {
    std::set<StreamKey> keys;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        keys.insert(derive_key({1}, "method " + std::to_string(i)));
        keys.insert(derive_key({2 + i}, "method 0"));
    }
    EXPECT_EQ(keys.size(), 20000u);
}

TEST(DeriveKey, UsesBothHalvesOfTheSeedAndAllOfTheText) {
    EXPECT_NE(derive_key({1}, "a"), derive_key({1 + (1ULL << 32)}, "a"));
    EXPECT_NE(derive_key({1}, "a"), derive_key({1}, "b"));
    EXPECT_NE(derive_key({1}, "ab"), derive_key({1}, "ba"));
    EXPECT_NE(derive_key({1}, ""), derive_key({1}, std::string_view("\0", 1)));
}

// Each of the 64 key bits should change with probability 1/2 between texts that differ in their last digit: over
// 10^4 pairs a share has standard error 0.005. The band of 6 of them is left by chance with probability 64 * 2e-9 =
// 1.3e-7, and a bit that changes with probability 0.55 or 0.45 (10 standard errors away) stays in it with 3e-5.
TEST(DeriveKey, ChangesEveryBitHalfOfTheTime) {
    constexpr int pairs = 10000;
    std::array<int, 64> changes{};
    for (int i = 0; i < pairs; ++i) {
        const std::string text = "patches " + std::to_string(i) + " samples ";
        const StreamKey a = derive_key({7}, text + "1");
        const StreamKey b = derive_key({7}, text + "2");
        for (std::size_t bit = 0; bit < 32; ++bit) {
            changes[bit] += static_cast<int>((a.word0 ^ b.word0) >> bit & 1u);
            changes[32 + bit] += static_cast<int>((a.word1 ^ b.word1) >> bit & 1u);
        }
    }
    const double standard_error = std::sqrt(0.25 / pairs);
    for (const int count : changes) {
        EXPECT_NEAR(static_cast<double>(count) / pairs, 0.5, 6 * standard_error);
    }
}

}  // namespace
}  // namespace ff

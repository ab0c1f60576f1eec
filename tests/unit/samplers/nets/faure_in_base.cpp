#include "samplers/nets/faure_in_base.hpp"

#include "samplers/nets/faure_digits.hpp"
#include "samplers/support/sizes.hpp"
#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace ff::samplers {
namespace {

constexpr Stream faure_in_base_stream{.key = {9, 1}, .trial = 3};

template <std::uint32_t base>
PointBlock faure_in_base_points(std::uint64_t set, PointIndex first, std::size_t count) {
    return test::block_of(FaureInBase<base>({.points = set}), faure_in_base_stream, first, count);
}

/// One point in each of the boxes base^-k_0 x ... x base^-k_3, for every k of sum 2.
template <std::uint32_t base>
bool is_net_in_base(const PointBlock& block) {
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = a; b < 4; ++b) {
            std::vector<bool> hit(integer_power(base, 2), false);
            for (std::size_t i = 0; i < block.size; ++i) {
                const std::uint64_t x = block.coordinate[a][i];
                const std::uint64_t y = block.coordinate[b][i];
                hit[a == b ? x * base * base >> 32 : (x * base >> 32) * base + (y * base >> 32)] = true;
            }
            if (std::count(hit.begin(), hit.end(), false) != 0) return false;
        }
    }
    return true;
}

template <std::uint32_t base>
void expect_nets() {
    for (const PointIndex first : {PointIndex{0}, PointIndex{base} * base, PointIndex{5} * base * base}) {
        EXPECT_TRUE(is_net_in_base<base>(faure_in_base_points<base>(integer_power(base, 4), first, base * base)))
            << base << ' ' << first;
    }
    EXPECT_FALSE(is_net_in_base<base>(faure_in_base_points<base>(integer_power(base, 4), 1, base * base))) << base;
}

TEST(FaureInBase, IsANetFromEveryMultipleOn) {
    expect_nets<7>();
    expect_nets<11>();
    expect_nets<13>();
}

TEST(FaureInBase, HasOnePointInEachBoxOfAFourFoldPartition) {
    std::vector<bool> hit(2401, false);
    for (PointIndex first = 0; first < 2401; first += 343) {
        const PointBlock block = faure_in_base_points<7>(2401, first, 343);
        for (std::size_t i = 0; i < block.size; ++i) {
            std::uint64_t cell = 0;
            for (std::size_t d = 0; d < 4; ++d) cell = cell * 7 + (std::uint64_t{block.coordinate[d][i]} * 7 >> 32);
            hit[cell] = true;
        }
    }
    EXPECT_EQ(std::count(hit.begin(), hit.end(), false), 0);
}

// python3 -c "
// from math import comb
// b, i = 7, 100
// a = [i // b**k % b for k in range(3)]
// for d in range(4): print([sum(comb(k, j) * d**(k - j) * a[k] for k in range(j, 3)) % b for j in range(3)])"
TEST(FaureDigits, EqualThePascalMatrixTimesTheIndexDigitsInBaseSeven) {
    const std::array<std::array<std::uint32_t, 3>, 4> expected{{{2, 0, 2}, {4, 4, 2}, {3, 1, 2}, {6, 5, 2}}};
    for (std::size_t d = 0; d < 4; ++d) {
        for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(faure_digits<7>(100, d)[j], expected[d][j]) << d << j;
    }
}

TEST(FaureInBase, RepeatsAFirstDigitExactlyWhereTheSequenceDoes) {
    // Scrambling is a bijection of digits: two points share their first digit exactly where the sequence has it equal.
    const PointBlock block = faure_in_base_points<7>(2401, 0, 343);
    for (std::size_t d = 0; d < 4; ++d) {
        for (std::size_t i = 1; i < block.size; ++i) {
            const bool same =
                block.coordinate[d][i] * std::uint64_t{7} >> 32 == block.coordinate[d][i - 1] * std::uint64_t{7} >> 32;
            EXPECT_EQ(same, faure_digits<7>(i, d)[0] == faure_digits<7>(i - 1, d)[0]);
        }
    }
}

}  // namespace
}  // namespace ff::samplers

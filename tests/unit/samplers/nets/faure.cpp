#include "samplers/nets/faure.hpp"

#include "samplers/nets/faure_digits.hpp"
#include "samplers/support/sizes.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace ff::samplers {
namespace {

constexpr Stream faure_stream{.key = {3, 1}, .trial = 4, .source = 1, .target = 5};

/// The digits of each coordinate as one integer below 5^m.
using NetPoints = std::array<std::vector<std::uint64_t>, max_dimension>;

NetPoints scrambled(std::size_t m, PointIndex first, const Stream& with = faure_stream) {
    const std::uint64_t points = integer_power(faure_base, m);
    NetPoints result;
    PointBlock block;
    for (PointIndex i = 0; i < points; i += block.size) {
        block.size = std::min<std::size_t>(block_capacity, points - i);
        Faure({.points = points}).fill(with, first + i, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::size_t k = 0; k < block.size; ++k) result[d].push_back(block.coordinate[d][k] * points >> 32);
        }
    }
    return result;
}

NetPoints unscrambled(std::size_t m, PointIndex first) {
    NetPoints result;
    for (PointIndex i = first; i < first + integer_power(faure_base, m); ++i) {
        for (std::size_t d = 0; d < max_dimension; ++d) {
            const FaureDigits digits = faure_digits(i, d);
            std::uint64_t value = 0;
            for (std::size_t j = 0; j < m; ++j) value = value * faure_base + digits[j];
            result[d].push_back(value);
        }
    }
    return result;
}

/// One point in each product of intervals of lengths 5^-k_d with k_0 + .. + k_3 = m.
bool has_one_point_a_box(const NetPoints& points, std::size_t m, const std::array<std::size_t, 4>& k) {
    std::vector<bool> hit(points[0].size(), false);
    for (std::size_t i = 0; i < hit.size(); ++i) {
        std::uint64_t box = 0;
        for (std::size_t d = 0; d < max_dimension; ++d) {
            box = box * integer_power(faure_base, k[d]) + points[d][i] / integer_power(faure_base, m - k[d]);
        }
        if (hit[box]) return false;
        hit[box] = true;
    }
    return true;
}

/// How many of the ways to cut the cube into 5^m elementary intervals have a point in each.
std::pair<int, int> count_filled_cuts(const NetPoints& points, std::size_t m) {
    int filled = 0;
    int cuts = 0;
    for (std::size_t a = 0; a <= m; ++a) {
        for (std::size_t b = 0; a + b <= m; ++b) {
            for (std::size_t c = 0; a + b + c <= m; ++c) {
                ++cuts;
                if (has_one_point_a_box(points, m, {a, b, c, m - a - b - c})) ++filled;
            }
        }
    }
    return {filled, cuts};
}

TEST(FaureDigits, MatchThePublishedConstruction) {
    // Coordinate 1 of points 1 to 5 and 25, from the definition by hand: the digits of the index are (1), .., (4),
    // (0, 1), (0, 0, 1); the first power of the Pascal matrix adds binomial(k, j) modulo 5.
    for (std::uint32_t i = 1; i < 5; ++i) EXPECT_EQ(faure_digits(i, 1)[0], i);
    EXPECT_EQ(faure_digits(5, 1), (FaureDigits{1, 1}));
    EXPECT_EQ(faure_digits(25, 1), (FaureDigits{1, 2, 1}));
    EXPECT_EQ(faure_digits(25, 2), (FaureDigits{4, 4, 1}));
    EXPECT_EQ(faure_digits(25, 3), (FaureDigits{4, 1, 1}));  // 9, 6, 1
}

TEST(Faure, HasOnePointInEveryElementaryInterval) {
    for (std::size_t m = 1; m <= 5; ++m) {
        const int cuts = static_cast<int>((m + 1) * (m + 2) * (m + 3) / 6);
        for (const PointIndex first : {PointIndex{0}, 3 * integer_power(faure_base, m)}) {
            EXPECT_EQ(count_filled_cuts(unscrambled(m, first), m), std::pair(cuts, cuts)) << m;
            EXPECT_EQ(count_filled_cuts(scrambled(m, first), m), std::pair(cuts, cuts)) << m;
        }
    }
}

TEST(FaureNet, IsLostWithTheFirstPointDropped) {
    const auto [filled, cuts] = count_filled_cuts(scrambled(4, 1), 4);
    EXPECT_LT(filled, cuts);
}

TEST(FaureNet, IsLostWithTwoEqualCoordinates) {
    NetPoints points = scrambled(4, 0);
    points[2] = points[1];
    EXPECT_LT(count_filled_cuts(points, 4).first, count_filled_cuts(points, 4).second);
}

TEST(Faure, ScramblesEveryStreamDifferently) {
    Stream other = faure_stream;
    ++other.trial;
    EXPECT_NE(scrambled(4, 0), scrambled(4, 0, other));
    EXPECT_NE(scrambled(4, 0), unscrambled(4, 0));
}

TEST(Faure, PermutesADigitByTheDigitsBeforeIt) {
    // Points 0 to 624 and 625 to 1249 of a set of 5^5 have different fifth digits, but go through the same nodes of the
    // tree above: whatever has the same first digits unscrambled has the same first digits scrambled.
    const NetPoints before = unscrambled(5, 0);
    const NetPoints after = scrambled(5, 0);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        for (std::size_t j = 1; j <= 5; ++j) {
            const std::uint64_t cell = integer_power(faure_base, 5 - j);
            std::map<std::uint64_t, std::uint64_t> image;
            for (std::size_t i = 0; i < before[d].size(); ++i) {
                EXPECT_EQ(image.try_emplace(before[d][i] / cell, after[d][i] / cell).first->second, after[d][i] / cell);
            }
        }
    }
}

TEST(Faure, TakesTwoDigitsToAnyTwoOthersEquallyOften) {
    // 20 ordered pairs, 20000 streams, for the root of the tree and for node (0, 0) of each coordinate: chi-squared
    // with 19 degrees of freedom exceeds 72.5 with probability 4e-8 (8 tests), and probabilities that are off by 10 %
    // (root mean square) are noticed nearly always (noncentrality 20000 * 0.01 = 200).
    constexpr std::uint32_t streams = 20000;
    std::array<std::map<std::pair<std::uint64_t, std::uint64_t>, double>, 8> counts;
    for (std::uint32_t trial = 0; trial < streams; ++trial) {
        const NetPoints points = scrambled(3, 0, {.key = {7, 7}, .trial = trial});
        for (std::size_t d = 0; d < max_dimension; ++d) {
            // Point 0 and point 1 differ in the first digit; find those with digits 0, 0, 0 and 0, 0, 1 for the other.
            ++counts[d][{points[d][0] / 25, points[d][1] / 25}];
            static const NetPoints digits = unscrambled(3, 0);
            const auto of = [&](std::uint64_t value) {
                const auto at = std::find(digits[d].begin(), digits[d].end(), value) - digits[d].begin();
                return points[d][static_cast<std::size_t>(at)] % 5;
            };
            ++counts[4 + d][{of(0), of(1)}];
        }
    }
    for (const auto& pairs : counts) {
        double statistic = 0;
        for (const auto& [pair, count] : pairs) {
            EXPECT_NE(pair.first, pair.second);
            statistic += (count - streams / 20.0) * (count - streams / 20.0) / (streams / 20.0);
        }
        EXPECT_EQ(pairs.size(), 20u);
        EXPECT_LT(statistic, 72.5);
    }
}

TEST(Faure, IsTheSameWithEveryInstructionSet) {
    for (const PointIndex first : {PointIndex{0}, PointIndex{611}, PointIndex{0xfffffc00}}) {
        for (const std::uint64_t points : {std::uint64_t{5}, std::uint64_t{625}, std::uint64_t{1} << 32}) {
            const auto sets = test::with_each_instruction_set([&] {
                PointBlock block;
                block.size = block_capacity;
                Faure({.points = points}).fill(faure_stream, first, block);
                return block.coordinate;
            });
            for (const auto& coordinate : sets) EXPECT_EQ(coordinate, sets.front());
        }
    }
}

TEST(Faure, DrawsThePlaceWithinTheSmallestCellAtRandom) {
    // 625 points have four digits; what is left of 625 x is what Philox gave.
    PointBlock block;
    block.size = 625;
    Faure({.points = 625}).fill(faure_stream, 0, block);
    for (std::uint32_t i = 0; i < 625; ++i) {
        for (std::size_t d = 0; d < max_dimension; ++d) {
            const std::uint64_t inside = block.coordinate[d][i] * 625ull & 0xffffffff;
            EXPECT_NEAR(static_cast<double>(inside), philox(faure_stream, i, Purpose::coordinates)[d],
                        625);  // rounded down
        }
    }
}

}  // namespace
}  // namespace ff::samplers

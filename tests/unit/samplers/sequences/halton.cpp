#include "samplers/sequences/halton.hpp"

#include "samplers/support/sizes.hpp"
#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace ff::samplers {
namespace {

constexpr std::array<std::uint64_t, 4> bases{2, 3, 5, 7};

PointBlock halton_points(const Stream& stream, std::uint64_t points, PointIndex first, std::size_t size) {
    return test::block_of(Halton({.points = points}), stream, first, size);
}

/// The first `count` digits of x 2^-32, as one number.
std::uint64_t leading_digits(std::uint32_t x, std::uint64_t base, std::size_t count) {
    return x * integer_power(base, count) >> 32;
}

TEST(Halton, PutsOnePointIntoEachInterval) {
    for (std::size_t d = 0; d < max_dimension; ++d) {
        for (std::size_t k = 1; integer_power(bases[d], k) <= 1000; ++k) {
            const std::uint64_t intervals = integer_power(bases[d], k);
            for (const PointIndex first : {PointIndex{0}, 3 * intervals}) {
                const PointBlock block = halton_points({.key = {4, 2}}, 5000, first, intervals);
                std::vector<bool> hit(intervals, false);
                for (std::size_t i = 0; i < intervals; ++i)
                    hit[leading_digits(block.coordinate[d][i], bases[d], k)] = true;
                EXPECT_EQ(std::count(hit.begin(), hit.end(), true), static_cast<std::ptrdiff_t>(intervals));
            }
        }
    }
}

TEST(Halton, PermutesEachDigitByItsPositionAlone) {
    for (std::size_t d = 0; d < max_dimension; ++d) {
        const std::uint64_t base = bases[d];
        const PointBlock block = halton_points({.key = {4, 2}, .trial = 8}, 1000, 0, 1000);
        std::map<std::uint64_t, std::uint64_t> second_digit;
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint64_t permuted = leading_digits(block.coordinate[d][i], base, 2) % base;
            EXPECT_EQ(second_digit.try_emplace(i / base % base, permuted).first->second, permuted);
        }
    }
}

TEST(Halton, DrawsEachPermutationOfThreeDigitsEquallyOften) {
    // 6 permutations, 6000 streams: chi-squared with 5 degrees of freedom exceeds 40.9 with probability 1e-7, and a
    // permutation that is 20 % too frequent or rare is noticed nearly always (noncentrality 6000 * 0.04 / 5 = 48).
    std::map<std::vector<std::uint64_t>, double> counts;
    constexpr double streams = 6000;
    for (std::uint32_t trial = 0; trial < 6000; ++trial) {
        const PointBlock block = halton_points({.key = {}, .trial = trial}, 9, 0, 3);
        std::vector<std::uint64_t> permutation;
        for (std::size_t i = 0; i < 3; ++i) permutation.push_back(leading_digits(block.coordinate[1][i], 3, 1));
        ++counts[permutation];
    }
    ASSERT_EQ(counts.size(), 6u);
    double statistic = 0;
    for (const auto& [permutation, count] : counts) {
        statistic += (count - streams / 6) * (count - streams / 6) / (streams / 6);
    }
    EXPECT_LT(statistic, 40.9);
}

TEST(Halton, ReachesTheLastIndexInEveryBase) {
    const PointIndex last = (std::uint64_t{1} << 32) - 1;
    const PointBlock end = halton_points({.key = {1, 1}}, last + 1, last - 1, 2);
    for (std::size_t d = 0; d < max_dimension; ++d) EXPECT_NE(end.coordinate[d][0], end.coordinate[d][1]);
}

}  // namespace
}  // namespace ff::samplers

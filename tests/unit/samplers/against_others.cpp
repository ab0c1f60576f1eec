// Unrandomised sequences beside those of other implementations, all packaged in Debian 12: scipy.stats.qmc 1.10,
// OpenTURNS 1.20, GSL 2.7.

#include "samplers/nets/boost_sequences.hpp"
#include "samplers/nets/faure_digits.hpp"
#include "samplers/nets/sobol_directions.hpp"
#include "samplers/sequences/halton.hpp"
#include "samplers/support/sizes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>

namespace ff::samplers {
namespace {

// python3 -c "from scipy.stats import qmc
// x = (qmc.Sobol(4, scramble=False).random(4096) * 4096).astype(int)
// print([int(sum(i * i * int(v) for i, v in enumerate(x[:, d])) % 2**32) for d in range(4)])"
TEST(AgainstScipy, SobolPointsAreTheSameInGrayCodeOrder) {
    constexpr std::array<std::uint32_t, 4> expected{7689216, 2681558016, 3494912, 1397760};
    for (std::size_t d = 0; d < 4; ++d) {
        std::uint32_t sum = 0;
        for (std::uint32_t i = 0; i < 4096; ++i) sum += i * i * (sobol_coordinate(i ^ i >> 1, d) >> 20);
        EXPECT_EQ(sum, expected[d]) << d;
    }
}

// python3 -c "from scipy.stats import qmc
// print((qmc.Halton(4, scramble=False).random(12) * [16, 27, 25, 49] + 1e-9).astype(int).tolist())"
TEST(AgainstScipy, HaltonPointsAreTheSameButForTheDigitPermutations) {
    constexpr std::array<std::array<std::uint32_t, 4>, 12> expected{{{0, 0, 0, 0},
                                                                     {8, 9, 5, 7},
                                                                     {4, 18, 10, 14},
                                                                     {12, 3, 15, 21},
                                                                     {2, 12, 20, 28},
                                                                     {10, 21, 1, 35},
                                                                     {6, 6, 6, 42},
                                                                     {14, 15, 11, 1},
                                                                     {1, 24, 16, 8},
                                                                     {9, 1, 21, 15},
                                                                     {5, 10, 2, 22},
                                                                     {13, 19, 7, 29}}};
    constexpr std::array<std::uint64_t, 4> cells{16, 27, 25, 49};
    for (std::uint32_t trial = 0; trial < 20; ++trial) {
        PointBlock block;
        block.size = 12;
        Halton({.points = 12}).fill({.key = {3, 4}, .trial = trial}, 0, block);
        for (std::size_t d = 0; d < 4; ++d) {
            // Cells correspond to cells one to one.
            std::map<std::uint64_t, std::uint64_t> there;
            std::map<std::uint64_t, std::uint64_t> back;
            for (std::size_t i = 0; i < block.size; ++i) {
                const std::uint64_t cell = block.coordinate[d][i] * cells[d] >> 32;
                EXPECT_EQ(there.try_emplace(expected[i][d], cell).first->second, cell);
                EXPECT_EQ(back.try_emplace(cell, expected[i][d]).first->second, expected[i][d]);
            }
        }
    }
}

/// Depends on every value and on their order.
std::uint32_t digest(std::uint32_t so_far, std::uint64_t value) {
    return so_far * 31 + static_cast<std::uint32_t>(value);
}

/// Digests of the first `digits` digits of points 1 to base^digits - 1 of the unscrambled sequence.
template <std::uint32_t base>
std::array<std::uint32_t, 4> faure_digests(std::size_t digits) {
    std::array<std::uint32_t, 4> digests{};
    for (std::uint64_t i = 1; i < integer_power(base, digits); ++i) {
        for (std::size_t d = 0; d < 4; ++d) {
            std::uint64_t value = 0;
            for (std::size_t j = 0; j < digits; ++j) value = value * base + faure_digits<base>(i, d)[j];
            digests[d] = digest(digests[d], value);
        }
    }
    return digests;
}

// python3 -c "import functools, openturns
// for b, k in (5, 5), (7, 4), (11, 3), (13, 3):
//     x = openturns.FaureSequence(b).generate(b**k - 1)  # of b coordinates, so that b is the base
//     print([functools.reduce(lambda h, p: (h * 31 + round(p[d] * b**k)) % 2**32, x, 0) for d in range(4)])"
TEST(AgainstOpenTurns, FaurePointsAreTheSameInEveryBase) {
    using Digests = std::array<std::uint32_t, 4>;
    EXPECT_EQ(faure_digests<5>(5), (Digests{3401598298, 2837734246, 656283542, 2947056182}));
    EXPECT_EQ(faure_digests<7>(4), (Digests{2844364464, 1788907624, 2103491200, 448750936}));
    EXPECT_EQ(faure_digests<11>(3), (Digests{3366237625, 1938933229, 3641061725, 1451491005}));
    EXPECT_EQ(faure_digests<13>(3), (Digests{2482047370, 1820402446, 406582926, 2025769062}));
}

// gsl_qrng* q = gsl_qrng_alloc(gsl_qrng_niederreiter_2, 4); gsl_qrng_get once for the origin, then 4096 times:
// h[d] = h[d] * 31 + (uint32_t)(v[d] * 4096); printf h
TEST(AgainstGsl, NiederreiterPointsAreTheSameWithoutTheOrigin) {
    constexpr std::array<std::uint32_t, 4> expected{889225217, 817923975, 486574636, 755011404};
    std::array<std::uint32_t, 4> digests{};
    PointBlock block;
    block.size = 1024;
    for (PointIndex first = 0; first < 4096; first += block.size) {
        Niederreiter({.points = 4096}).fill({}, first, block);
        for (std::size_t d = 0; d < 4; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) digests[d] = digest(digests[d], block.coordinate[d][i] >> 20);
        }
    }
    EXPECT_EQ(digests, expected);
}

}  // namespace
}  // namespace ff::samplers

// Unrandomised sequences beside those of another implementation, scipy.stats.qmc 1.10.

#include "samplers/halton.hpp"
#include "samplers/sobol_directions.hpp"

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
    constexpr std::uint32_t expected[12][4] = {{0, 0, 0, 0},    {8, 9, 5, 7},    {4, 18, 10, 14}, {12, 3, 15, 21},
                                               {2, 12, 20, 28}, {10, 21, 1, 35}, {6, 6, 6, 42},   {14, 15, 11, 1},
                                               {1, 24, 16, 8},  {9, 1, 21, 15},  {5, 10, 2, 22},  {13, 19, 7, 29}};
    constexpr std::array<std::uint64_t, 4> cells{16, 27, 25, 49};
    for (std::uint32_t trial = 0; trial < 20; ++trial) {
        PointBlock block;
        block.size = 12;
        Halton({.points = 12}).fill({.key = {3, 4}, .trial = trial}, 0, block);
        for (std::size_t d = 0; d < 4; ++d) {
            // Cells go to cells one to one.
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

}  // namespace
}  // namespace ff::samplers

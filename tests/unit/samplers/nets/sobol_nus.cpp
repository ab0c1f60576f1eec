#include "samplers/nets/sobol_nus.hpp"

#include "samplers/nets/sobol.hpp"
#include "samplers/nets/sobol_directions.hpp"
#include "samplers/nets/sobol_lms.hpp"
#include "tests/unit/samplers/nets/net.hpp"
#include "tests/unit/samplers/nets/scrambling.hpp"

#include <gtest/gtest.h>

#include <map>

namespace ff::test {
namespace {

using samplers::SobolNus;

constexpr std::size_t sobol_set_size = 256;

void fill_sobol_by_hash(const Stream& stream, PointBlock& block) {
    samplers::Sobol({.points = sobol_set_size}).fill(stream, 0, block);
}

void fill_sobol_by_matrix(const Stream& stream, PointBlock& block) {
    samplers::SobolLms({.points = sobol_set_size}).fill(stream, 0, block);
}

void fill_sobol_by_tree(const Stream& stream, PointBlock& block) {
    SobolNus({.points = sobol_set_size}).fill(stream, 0, block);
}

/// A random digital shift alone: it keeps the net and is unbiased, but scrambles nothing.
void fill_sobol_by_shift(const Stream& stream, PointBlock& block) {
    const Words shift = philox(stream, 0, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] = samplers::sobol_coordinate(i, d) ^ shift[d];
        }
    }
}

TEST(SobolNus, SwapsTheHalvesOfEachNodeByItsOwnBit) {
    const Stream stream{.key = {5, 6}, .trial = 7};
    PointBlock block;
    block.size = 1024;
    SobolNus({.points = 1024}).fill(stream, 0, block);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        for (unsigned depth = 0; depth < 10; ++depth) {
            std::map<std::uint32_t, std::uint32_t> swaps;
            std::uint32_t swapped = 0;
            for (std::uint32_t i = 0; i < block.size; ++i) {
                const std::uint32_t before = samplers::sobol_coordinate(i, d);
                const std::uint32_t swap = (before ^ block.coordinate[d][i]) >> (31 - depth) & 1u;
                const auto [at, is_new] = swaps.try_emplace(depth == 0 ? 0 : before >> (32 - depth), swap);
                EXPECT_EQ(at->second, swap);
                if (is_new) swapped += swap;
            }
            EXPECT_EQ(swaps.size(), std::size_t{1} << depth);
            // Fair coins: of 512 none of the 4 counts is beyond 256 +- 68, six standard deviations, but once in 10^8.
            if (depth == 9) {
                EXPECT_NEAR(swapped, 256, 68);
            }
        }
    }
}

TEST(SobolNus, KeepsTheNet) {
    for (const unsigned m : {4u, 8u}) {
        Coordinates plain;
        Coordinates scrambled;
        PointBlock block;
        block.size = std::size_t{1} << m;
        SobolNus({.points = block.size}).fill({.key = {1, 1}}, 0, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::uint32_t i = 0; i < block.size; ++i) {
                plain[d].push_back(samplers::sobol_coordinate(i, d));
                scrambled[d].push_back(block.coordinate[d][i]);
            }
        }
        EXPECT_EQ(net_parameter(scrambled, m), net_parameter(plain, m));
    }
}

class FastScramblings : public testing::TestWithParam<Integral> {};

TEST_P(FastScramblings, HaveTheMeanAndVarianceOfTheTree) {
    const auto tree = scrambled_estimates(fill_sobol_by_tree, GetParam(), sobol_set_size);
    const auto hash = scrambled_estimates(fill_sobol_by_hash, GetParam(), sobol_set_size);
    const auto matrix = scrambled_estimates(fill_sobol_by_matrix, GetParam(), sobol_set_size);
    EXPECT_TRUE(has_mean(tree, GetParam()));
    EXPECT_TRUE(has_mean(hash, GetParam()));
    EXPECT_TRUE(has_mean(matrix, GetParam()));
    EXPECT_TRUE(have_same_variance(hash, tree));
    EXPECT_TRUE(have_same_variance(matrix, tree));
}

INSTANTIATE_TEST_SUITE_P(Integrands, FastScramblings, testing::ValuesIn(scrambling_integrals()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(FastScramblingsCheck, CatchesADigitalShiftInPlaceOfScrambling) {
    const Integral smooth = scrambling_integrals().front();
    EXPECT_FALSE(have_same_variance(scrambled_estimates(fill_sobol_by_shift, smooth, sobol_set_size),
                                    scrambled_estimates(fill_sobol_by_tree, smooth, sobol_set_size)));
}

}  // namespace
}  // namespace ff::test

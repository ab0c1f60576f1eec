#include "samplers/nets/faure.hpp"
#include "samplers/nets/faure_digits.hpp"
#include "samplers/support/sizes.hpp"
#include "tests/unit/samplers/nets/scrambling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

// Affine permutations drawn by a hash against all 120, drawn by Philox, a fresh one for each node of the tree of
// digits.

namespace ff::test {
namespace {

constexpr std::size_t faure_set_size = 625;
constexpr std::size_t faure_set_digits = 4;

using Permutation = std::array<std::uint32_t, samplers::faure_base>;

/// Any of the 120, by the order of five random words.
Permutation permutation_of(const Stream& stream, std::uint32_t node, std::size_t dimension) {
    const std::uint32_t index = (node * 4 + static_cast<std::uint32_t>(dimension)) * 2;
    const Words first = philox(stream, index, Purpose::permutation);
    const Words second = philox(stream, index + 1, Purpose::permutation);
    const Permutation words{first[0], first[1], first[2], first[3], second[0]};
    Permutation result{};
    std::iota(result.begin(), result.end(), 0u);
    std::sort(result.begin(), result.end(), [&](std::uint32_t a, std::uint32_t b) { return words[a] < words[b]; });
    return result;
}

void fill_faure_by_tree(const Stream& stream, PointBlock& block) {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            const samplers::FaureDigits before = samplers::faure_digits(i, d);
            std::uint64_t after = 0;
            std::uint32_t node = 0;
            for (std::size_t j = 0; j < faure_set_digits; ++j) {
                after = after * samplers::faure_base + permutation_of(stream, node, d)[before[j]];
                node = node * samplers::faure_base + before[j] + 1;
            }
            const std::uint32_t inside = philox(stream, i, Purpose::coordinates)[d];
            block.coordinate[d][i] = static_cast<std::uint32_t>(((after << 32) + inside) / faure_set_size);
        }
    }
}

/// One permutation a digit position, whatever the digits before it: keeps the net, and is not nested.
void fill_faure_by_position(const Stream& stream, PointBlock& block) {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            const samplers::FaureDigits before = samplers::faure_digits(i, d);
            std::uint64_t after = 0;
            for (std::uint32_t j = 0; j < faure_set_digits; ++j) {
                after = after * samplers::faure_base + permutation_of(stream, j, d)[before[j]];
            }
            block.coordinate[d][i] = static_cast<std::uint32_t>(((after << 32) + 0x80000000u) / faure_set_size);
        }
    }
}

void fill_faure_by_hash(const Stream& stream, PointBlock& block) {
    samplers::Faure({.points = faure_set_size}).fill(stream, 0, block);
}

class FaureAgainstTree : public testing::TestWithParam<Integral> {};

TEST_P(FaureAgainstTree, HasTheSameMeanAndVariance) {
    const auto hash = scrambled_estimates(fill_faure_by_hash, GetParam(), faure_set_size);
    const auto tree = scrambled_estimates(fill_faure_by_tree, GetParam(), faure_set_size);
    EXPECT_TRUE(has_mean(hash, GetParam()));
    EXPECT_TRUE(has_mean(tree, GetParam()));
    EXPECT_TRUE(have_same_variance(hash, tree));
}

INSTANTIATE_TEST_SUITE_P(Integrands, FaureAgainstTree, testing::ValuesIn(scrambling_integrals()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(FaureAgainstTreeCheck, CatchesPermutationsByPosition) {
    const Integral smooth = scrambling_integrals().front();
    EXPECT_FALSE(have_same_variance(scrambled_estimates(fill_faure_by_position, smooth, faure_set_size),
                                    scrambled_estimates(fill_faure_by_tree, smooth, faure_set_size)));
}

}  // namespace
}  // namespace ff::test

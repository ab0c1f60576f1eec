#include "tests/unit/samplers/nets/net.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ff::test {
namespace {

/// The first k binary digits.
std::uint32_t leading_bits(std::uint32_t x, unsigned k) {
    return k == 0 ? 0 : x >> (32 - k);
}

bool equally_filled(const Coordinates& points, const std::array<unsigned, 4>& k, unsigned bits) {
    std::vector<std::size_t> counts(std::size_t{1} << bits, 0);
    for (std::size_t i = 0; i < points[0].size(); ++i) {
        std::uint32_t interval = 0;
        for (std::size_t d = 0; d < 4; ++d) interval = interval << k[d] | leading_bits(points[d][i], k[d]);
        ++counts[interval];
    }
    return std::all_of(counts.begin(), counts.end(), [&](std::size_t count) { return count == counts[0]; });
}

bool is_net(const Coordinates& points, unsigned bits) {
    for (unsigned a = 0; a <= bits; ++a) {
        for (unsigned b = 0; a + b <= bits; ++b) {
            for (unsigned c = 0; a + b + c <= bits; ++c) {
                if (!equally_filled(points, {a, b, c, bits - a - b - c}, bits)) return false;
            }
        }
    }
    return true;
}

TEST(NetParameter, IsLargestForPointsOnADiagonal) {
    Coordinates diagonal;
    for (auto& x : diagonal) x = {0, 0x40000000, 0x80000000, 0xc0000000};
    EXPECT_EQ(net_parameter(diagonal, 2), 1u);
    for (auto& x : diagonal) x = {0, 0, 0, 0};
    EXPECT_EQ(net_parameter(diagonal, 2), 2u);
}

}  // namespace

unsigned net_parameter(const Coordinates& points, unsigned m) {
    unsigned t = 0;
    while (!is_net(points, m - t)) ++t;
    return t;
}

}  // namespace ff::test

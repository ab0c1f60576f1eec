#include "samplers/point_sets/parts.hpp"

#include "samplers/point_sets/net_parameter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace ff::samplers {
namespace {

std::uint32_t word_of(double x) {
    return static_cast<std::uint32_t>(std::min(x * 0x1p32, 0x1p32 - 1));
}

/// i / n and the radical inverse of i, at the lower end of each n-th, `end` 0, or at its upper end, 1; rounded once.
PointSet exact_net(std::uint32_t base, std::uint64_t n, std::uint64_t end = 0) {
    PointSet set{n, 2, 1, {}};
    const auto add = [&](std::uint64_t part) {
        set.coordinate.push_back(word_of(static_cast<double>(part + end) / static_cast<double>(n)));
    };
    for (std::uint64_t i = 0; i < n; ++i) add(i);
    for (std::uint64_t i = 0; i < n; ++i) {
        std::uint64_t inverse = 0;
        std::uint64_t left = i;
        for (std::uint64_t scale = 1; scale < n; scale *= base, left /= base) inverse = inverse * base + left % base;
        add(inverse);
    }
    return set;
}

TEST(Parts, AreExactInBaseTwo) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto x = static_cast<std::uint32_t>(random());
        for (unsigned k = 0; k <= 32; ++k) {
            const std::uint64_t parts = std::uint64_t{1} << k;
            EXPECT_EQ(part_of(x, parts, Edge::upper), std::uint64_t{x} << k >> 32);
            EXPECT_EQ(part_of(x, parts, Edge::lower), std::uint64_t{x} << k >> 32);
        }
    }
}

TEST(Parts, BeginWithTheirLowerBoundary) {
    for (const std::uint64_t parts : {1u, 2u, 3u, 7u, 12u, 243u, 1000u, 59049u})
        for (std::uint64_t k = 0; k < parts; ++k)
            ASSERT_EQ(part_of(word_of(static_cast<double>(k) / static_cast<double>(parts)), parts), k) << parts;
    EXPECT_EQ(part_of(~0u, std::uint64_t{1} << 32), ~0u);
    EXPECT_EQ(part_of(~0u, 3), 2u);
}

TEST(Parts, HoldOnePointEachForExactNetsOfAnyBase) {
    const std::pair<std::uint32_t, std::uint64_t> nets[] = {{2, 64},  {3, 27}, {3, 243},  {5, 125}, {5, 625},
                                                            {7, 343}, {7, 49}, {11, 121}, {13, 169}};
    for (const auto& [base, n] : nets) {
        EXPECT_EQ(net_parameter(exact_net(base, n), 0, base), 0u) << base << ' ' << n;
        if (base == 2) continue;  // where points at the upper end are in the next part
        EXPECT_EQ(net_parameter(exact_net(base, n, 1), 0, base), 0u) << base << ' ' << n;
    }
}

TEST(Parts, ShowAMovedPointOfAnExactNet) {
    for (const auto& [base, n] : {std::pair{3u, 243u}, std::pair{5u, 125u}, std::pair{7u, 343u}}) {
        for (const std::size_t moved : {1u, 40u, n + 2u, n + 100u}) {
            PointSet set = exact_net(base, n);
            set.coordinate[moved] += 0x30000000;
            EXPECT_GT(net_parameter(set, 0, base), 0u) << base << ' ' << moved;
            set = exact_net(base, n);
            set.coordinate[moved] += static_cast<std::uint32_t>(0x1p32 / n) + 1;
            EXPECT_GT(net_parameter(set, 0, base), 0u) << base << ' ' << moved << ", to the next part";
        }
    }
}

// Points anywhere lie in a cell with a boundary by chance, and some of many on either side of it.
TEST(Parts, LeaveOpenAPointThatChancePutOnABoundary) {
    constexpr std::uint64_t n = 59049;
    PointSet set{n, 1, 1, {}};
    for (std::uint64_t i = 0; i < n; ++i) set.coordinate.push_back(word_of((static_cast<double>(i) + 0.5) / n));
    set.coordinate[100] = word_of(100.0 / n);  // at the lower end of its slice
    set.coordinate[200] = word_of(201.0 / n);  // at the upper end
    EXPECT_EQ(part_of(set.coordinate[200], n), 201u);
    EXPECT_EQ(part_of(set.coordinate[100], n, Edge::lower), 99u);
    EXPECT_EQ(net_parameter(set, 0, 3), 0u);
    set.coordinate[300] = set.coordinate[301];
    EXPECT_EQ(net_parameter(set, 0, 3), 1u);
}

}  // namespace
}  // namespace ff::samplers

#include "samplers/nets/boost_sequences.hpp"

#include "samplers/nets/sobol_directions.hpp"
#include "tests/unit/samplers/nets/net.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

/// 2^m points: the origin, which the engine skips, and the points after it.
test::Coordinates whole_net(unsigned m) {
    test::Coordinates points;
    PointBlock block;
    block.size = (std::size_t{1} << m) - 1;
    Niederreiter({.points = block.size}).fill({}, 0, block);
    for (std::size_t d = 0; d < max_dimension; ++d) {
        points[d].push_back(0);
        points[d].insert(points[d].end(), block.coordinate[d].begin(),
                         block.coordinate[d].begin() + static_cast<std::ptrdiff_t>(block.size));
    }
    return points;
}

TEST(Niederreiter, IsANetOfTheKnownParameterWithTheOrigin) {
    // t <= the sum of (degree - 1) over x, x + 1, x^2 + x + 1, x^3 + x + 1 [niederreiter1988].
    for (unsigned m = 4; m <= 10; ++m) EXPECT_LE(test::net_parameter(whole_net(m), m), 3u);
}

TEST(Niederreiter, IsNotSuchANetWithoutTheOrigin) {
    test::Coordinates points = whole_net(8);
    PointBlock block;
    block.size = 1;
    Niederreiter({.points = 256}).fill({}, 255, block);
    for (std::size_t d = 0; d < max_dimension; ++d) points[d][0] = block.coordinate[d][0];
    EXPECT_GT(test::net_parameter(points, 8), 3u);
}

TEST(Niederreiter, StartsWithVanDerCorputInGrayCodeOrder) {
    // The polynomial x makes coordinate 0 the radical inverse: 1/2, 3/4, 1/4 for points 1, 3, 2 of natural order.
    PointBlock block;
    block.size = 3;
    Niederreiter({.points = 3}).fill({}, 0, block);
    EXPECT_EQ(block.coordinate[0][0], 0x80000000u);
    EXPECT_EQ(block.coordinate[0][1], 0xc0000000u);
    EXPECT_EQ(block.coordinate[0][2], 0x40000000u);
}

/// Position in natural order of the point that Gray code visits at `index`.
std::uint32_t gray_code(std::uint32_t index) {
    return index ^ index >> 1;
}

TEST(SobolRaw, IsTheSequenceOfJoeAndKuoInGrayCodeOrderWithoutTheOrigin) {
    for (const std::uint32_t first : {0u, 1u, 1000u, 0x7ffffff0u}) {
        PointBlock block;
        block.size = 1024;
        SobolRaw({.points = max_points}).fill({}, first, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::uint32_t i = 0; i < block.size; ++i) {
                EXPECT_EQ(block.coordinate[d][i], sobol_coordinate(gray_code(first + i + 1), d));
            }
        }
    }
}

}  // namespace
}  // namespace ff::samplers

#include "samplers/point_sets/net_parameter.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

PointSet point_set_of(std::string_view sampler, std::uint64_t points, std::size_t dimension) {
    const auto source = find(sampler).make({.points = points, .dimension = dimension});
    PointSet set{points, dimension, 1, {}};
    PointBlock block;
    block.dimension = dimension;
    block.size = points;
    source->fill({}, 0, block);
    for (std::size_t d = 0; d < dimension; ++d)
        set.coordinate.insert(set.coordinate.end(), block.coordinate[d].begin(),
                              block.coordinate[d].begin() + static_cast<std::ptrdiff_t>(points));
    return set;
}

// The first two coordinates of Sobol' are a (0, 2)-sequence; Faure's in base 5 a (0, 4)-sequence [niederreiter1992].
TEST(NetParameter, IsZeroForTheBestNets) {
    EXPECT_EQ(net_parameter(point_set_of("sobol", 256, 2), 0, 2), 0u);
    EXPECT_EQ(net_parameter(point_set_of("faure", 625, 4), 0, 5), 0u);
}

// t of the Sobol' sequence in four dimensions is at most 3, the sum of the degrees of its polynomials less one each.
TEST(NetParameter, IsAtMostThreeForSobol) {
    for (const std::uint64_t n : {16u, 64u, 256u, 1024u})
        EXPECT_LE(net_parameter(point_set_of("sobol", n, 4), 0, 2), 3u);
}

TEST(NetParameter, IsLargeForRandomPointsAndGrowsWhenOneIsMoved) {
    EXPECT_GT(net_parameter(point_set_of("random", 1024, 4), 0, 2), 4u);
    PointSet net = point_set_of("sobol", 64, 2);
    ASSERT_EQ(net_parameter(net, 0, 2), 0u);
    net.coordinate[5] ^= 1u << 31;
    EXPECT_GT(net_parameter(net, 0, 2), 0u);
}

// Without its first point the sequence is not a net [owen2022].
TEST(NetParameter, IsPositiveWhereTheOriginIsMissing) {
    EXPECT_GT(net_parameter(point_set_of("sobol_raw", 256, 2), 0, 2), 0u);
}

TEST(NetParameter, IsEmptyUnlessTheNumberOfPointsIsAPower) {
    EXPECT_FALSE(net_parameter(point_set_of("random", 100, 2), 0, 2));
    EXPECT_EQ(net_parameter(point_set_of("random", 1, 2), 0, 2), 0u);
}

}  // namespace
}  // namespace ff::samplers

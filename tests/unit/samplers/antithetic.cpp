#include "samplers/antithetic.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

TEST(Antithetic, FollowsEachRandomPointByItsMirrorImage) {
    const Stream stream{.key = {4, 4}, .trial = 2};
    PointBlock random;
    random.size = 600;
    Random({.points = 600}).fill(stream, 0, random);
    for (const PointIndex first : {0u, 1u, 6u, 177u}) {
        PointBlock block;
        block.size = 1000;
        Antithetic({.points = 1200}).fill(stream, first, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) {
                const std::uint32_t u = random.coordinate[d][(first + i) / 2];
                EXPECT_EQ(block.coordinate[d][i], (first + i) % 2 == 0 ? u : 0xffffffff - u);
            }
        }
    }
}

}  // namespace
}  // namespace ff::samplers

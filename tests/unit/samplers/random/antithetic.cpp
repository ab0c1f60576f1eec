#include "samplers/random/antithetic.hpp"

#include "samplers/nets/sobol.hpp"

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
        Antithetic<Random>({.points = 1200}).fill(stream, first, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) {
                const std::uint32_t u = random.coordinate[d][(first + i) / 2];
                EXPECT_EQ(block.coordinate[d][i], (first + i) % 2 == 0 ? u : 0xffffffff - u);
            }
        }
    }
}

TEST(Antithetic, TakesHalfOfItsPointsFromTheUnderlyingSampler) {
    const Stream stream{.key = {4, 4}, .trial = 2};
    PointBlock sobol;
    sobol.size = 8;
    Sobol({.points = 8}).fill(stream, 0, sobol);
    PointBlock block;
    block.size = 15;
    block.dimension = 2;
    Antithetic<Sobol>({.points = 15, .dimension = 2}).fill(stream, 0, block);
    for (std::size_t d = 0; d < 2; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            EXPECT_EQ(block.coordinate[d][i], i % 2 == 0 ? sobol.coordinate[d][i / 2] : ~sobol.coordinate[d][i / 2]);
        }
    }
}

TEST(Antithetic, DeclaresTwiceTheSizes) {
    EXPECT_EQ(Antithetic<Sobol>::info.name, "antithetic_sobol");
    EXPECT_EQ(Antithetic<Sobol>::info.multiple, 2u);
    EXPECT_EQ(Antithetic<Random>::info.name, "antithetic");
    EXPECT_EQ(Antithetic<Random>::info.sizes, Sizes::any);
    EXPECT_FALSE(Antithetic<Random>::info.independent());
}

}  // namespace
}  // namespace ff::samplers

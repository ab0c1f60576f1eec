#include "samplers/support/entry.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

TEST(WeighEqually, PlacesPointsInTheCentresOfTheirCells) {
    PointBlock cells;
    cells.dimension = 2;
    cells.size = 2;
    cells.coordinate[0] = {0, 0x80000000};
    cells.coordinate[1] = {0xffffffff, 1};
    WeightedBlock block;
    block.dimension = 2;
    block.size = 2;
    weigh_equally(cells, 8, block);
    EXPECT_EQ(block.coordinate[0][0], 0x1p-33);
    EXPECT_EQ(block.coordinate[0][1], 0.5 + 0x1p-33);
    EXPECT_EQ(block.coordinate[1][0], 1 - 0x1p-33);
    EXPECT_EQ(block.coordinate[1][1], 3 * 0x1p-33);
    EXPECT_EQ(block.weight[0], 0.125);
    EXPECT_EQ(block.weight[1], 0.125);
}

}  // namespace
}  // namespace ff::samplers

#include "core/points/points.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

/// Two points of a set of eight.
class TwoOfEight : public PointSource {
  public:
    [[nodiscard]] std::uint64_t points() const override { return 8; }
    [[nodiscard]] bool randomised() const override { return false; }
    [[nodiscard]] bool equal_weights() const override { return true; }

    using PointSource::fill;
    void fill(const Stream& /*stream*/, PointIndex /*first*/, PointBlock& block) const override {
        block.coordinate[0] = {0, 0x80000000};
        block.coordinate[1] = {0xffffffff, 1};
    }
};

TEST(PointSource, PlacesPointsOfEqualWeightInTheCentresOfTheirCells) {
    WeightedBlock block;
    block.dimension = 2;
    block.size = 2;
    TwoOfEight().fill({}, 0, block);
    EXPECT_EQ(block.coordinate[0][0], 0x1p-33);
    EXPECT_EQ(block.coordinate[0][1], 0.5 + 0x1p-33);
    EXPECT_EQ(block.coordinate[1][0], 1 - 0x1p-33);
    EXPECT_EQ(block.coordinate[1][1], 3 * 0x1p-33);
    EXPECT_EQ(block.weight[0], 0.125);
    EXPECT_EQ(block.weight[1], 0.125);
}

}  // namespace
}  // namespace ff

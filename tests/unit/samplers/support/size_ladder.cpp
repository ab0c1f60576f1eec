#include "samplers/support/size_ladder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

using testing::ElementsAre;

std::vector<std::uint64_t> ladder(Sizes sizes, std::uint64_t low, std::uint64_t high, std::size_t dimension = 4,
                                  std::uint32_t base = 2, std::uint32_t multiple = 1) {
    SamplerInfo info;
    info.sizes = sizes;
    info.base = base;
    info.multiple = multiple;
    return size_ladder(info, low, high, dimension);
}

TEST(SizeLadder, TakesPowersOfTheBaseOfANet) {
    EXPECT_THAT(ladder(Sizes::powers, 64, 512), ElementsAre(64, 128, 256, 512));
    EXPECT_THAT(ladder(Sizes::powers, 64, 65'536, 4, 5), ElementsAre(125, 625, 3125, 15'625));
    EXPECT_THAT(ladder(Sizes::powers, 100, 1000, 4, 2, 3), ElementsAre(192, 384, 768));
}

TEST(SizeLadder, TakesPowersOfTwoWhereEverySizeWillDo) {
    EXPECT_THAT(ladder(Sizes::any, 60, 300), ElementsAre(64, 128, 256));
}

// k^4: of 4096 = 8^4 and 6561 = 9^4, both between 2^12 and 2^13, the smaller
TEST(SizeLadder, TakesOneFullGridAnOctave) {
    EXPECT_THAT(ladder(Sizes::fourth_power, 64, 10'000), ElementsAre(81, 256, 625, 1296, 2401, 4096, 10'000));
    EXPECT_THAT(ladder(Sizes::fourth_power, 64, 600, 2), ElementsAre(64, 144, 256, 529));
}

TEST(SizeLadder, KeepsWithinTheRange) {
    EXPECT_THAT(ladder(Sizes::powers, 65, 127), ElementsAre());
    EXPECT_THAT(ladder(Sizes::fourth_power, 1, 1), ElementsAre(1));
    EXPECT_THAT(ladder(Sizes::powers, max_points / 2, max_points, 4, 5), ElementsAre());
    EXPECT_THAT(ladder(Sizes::powers, max_points, max_points), ElementsAre(max_points));
}

}  // namespace
}  // namespace ff::samplers

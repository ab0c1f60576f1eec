#include "samplers/support/sizes.hpp"

#include "core/support/error.hpp"
#include "samplers/sampler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

using testing::HasSubstr;

SamplerInfo made_for(Sizes sizes) {
    return {.name = "example", .summary = "", .details = "", .reference = "", .sizes = sizes};
}

TEST(FloorRoot, IsTheLargestRootForPowersAndTheirNeighbours) {
    for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
        for (const std::uint64_t k : {1u, 2u, 3u, 5u, 13u, 100u, 255u, 256u}) {
            const std::uint64_t power = integer_power(k, dimension);
            EXPECT_EQ(floor_root(power, dimension), k);
            EXPECT_EQ(floor_root(power - 1, dimension), k - 1);
        }
        EXPECT_EQ(integer_power(floor_root(max_points, dimension), dimension) > max_points, false);
    }
    EXPECT_EQ(floor_root(max_points, 1), max_points);
    EXPECT_EQ(floor_root(max_points, 2), 65536u);
    EXPECT_EQ(floor_root(max_points, 3), 1625u);  // python3 -c "print(1625**3 <= 2**32 < 1626**3)"
}

TEST(Reciprocal, IsRoundedDown) {
    EXPECT_EQ(reciprocal(2), std::uint64_t{1} << 63);
    EXPECT_EQ(reciprocal(3), 0x5555555555555555u);
    EXPECT_EQ(reciprocal(5), 0x3333333333333333u);
    EXPECT_EQ(reciprocal(7), 2635249153387078802u);  // python3 -c "print(2**64 // 7)"
    EXPECT_EQ(reciprocal(1u << 31), std::uint64_t{1} << 33);
}

TEST(CheckSize, RefusesNoPointsAndTooMany) {
    for (const Sizes sizes : {Sizes::any, Sizes::powers, Sizes::fourth_power, Sizes::nodes}) {
        EXPECT_TRUE(check_size(made_for(sizes), 0).fatal);
        EXPECT_TRUE(check_size(made_for(sizes), max_points + 1).fatal);
        EXPECT_FALSE(check_size(made_for(sizes), max_points).fatal);
    }
}

TEST(CheckSize, NamesTheNearestFourthPowers) {
    EXPECT_EQ(check_size(made_for(Sizes::fourth_power), 625).message, "");
    const SizeProblem problem = check_size(made_for(Sizes::fourth_power), 1000);
    EXPECT_TRUE(problem.fatal);
    EXPECT_THAT(problem.message, HasSubstr("625 = 5^4 or 1296 = 6^4"));
}

TEST(CheckSize, NamesOneNeighbourAtTheUpperEnd) {
    EXPECT_THAT(check_size(made_for(Sizes::fourth_power), max_points - 1).message,
                HasSubstr("4228250625 = 255^4 or 4294967296 = 256^4"));
}

TEST(CheckSize, CountsCellsInTheDimensionOfThePoints) {
    EXPECT_EQ(check_size(made_for(Sizes::fourth_power), 49, 2).message, "");
    EXPECT_THAT(check_size(made_for(Sizes::fourth_power), 50, 2).message, HasSubstr("49 = 7^2 or 64 = 8^2"));
}

TEST(CountDigits, GrowsWithTheFirstPointBeyondAPower) {
    EXPECT_EQ(count_digits(1, 5), 1u);
    EXPECT_EQ(count_digits(5, 5), 1u);
    EXPECT_EQ(count_digits(6, 5), 2u);
    EXPECT_EQ(count_digits(625, 5), 4u);
    EXPECT_EQ(count_digits(626, 5), 5u);
    EXPECT_EQ(count_digits(max_points, 2), 32u);
    EXPECT_EQ(count_digits(max_points, 5), 14u);  // python3 -c "print(5**13 < 2**32 < 5**14)"
}

SamplerInfo powers_of(std::uint32_t base, std::uint32_t multiple = 1) {
    SamplerInfo info = made_for(Sizes::powers);
    info.base = base;
    info.multiple = multiple;
    return info;
}

TEST(CheckSize, OnlyWarnsOfSizesBetweenPowersOfFive) {
    for (const std::uint64_t points : {1u, 5u, 625u, 1220703125u}) {
        EXPECT_EQ(check_size(powers_of(5), points).message, "");
    }
    const SizeProblem problem = check_size(powers_of(5), 1024);
    EXPECT_FALSE(problem.fatal);
    EXPECT_THAT(problem.message, HasSubstr("625 = 5^4 or 3125 = 5^5"));
    EXPECT_THAT(check_size(powers_of(5), max_points).message, HasSubstr("Nearest: 1220703125 = 5^13."));
}

TEST(CheckSize, OnlyWarnsOfSizesBetweenPowersOfTwo) {
    EXPECT_EQ(check_size(powers_of(2), max_points).message, "");
    EXPECT_EQ(check_size(powers_of(2), 512).message, "");
    const SizeProblem problem = check_size(powers_of(2), 625);
    EXPECT_FALSE(problem.fatal);
    EXPECT_THAT(problem.message, HasSubstr("512 = 2^9 or 1024 = 2^10"));
}

TEST(CheckSize, KnowsMultiplesOfPowers) {
    EXPECT_EQ(check_size(powers_of(5, 2), 1250).message, "");
    const SizeProblem problem = check_size(powers_of(5, 2), 625);
    EXPECT_FALSE(problem.fatal);
    EXPECT_THAT(problem.message, HasSubstr("at 2 times powers of 5 only). Nearest: 250 = 2 * 5^3 or 1250 = 2 * 5^4."));
    EXPECT_THAT(check_size(powers_of(5, 2), 1).message, HasSubstr("Nearest: 2 = 2 * 5^0 or 10 = 2 * 5^1."));
}

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
TEST(SizeLadder, TakesOneFullGridPerOctave) {
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

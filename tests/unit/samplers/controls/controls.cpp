#include "samplers/sampler.hpp"

#include "tests/unit/samplers/blocks.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

// tests/contract/broken_samplers.cpp shows which checks catch each control; here it is tested that they are what they
// claim to be.

namespace ff::samplers {
namespace {

PointBlock sixteen_points(std::string_view name, std::uint32_t trial = 0, PointIndex first = 0) {
    return test::block_of(*find(name).make({.points = 64}), {.key = {1, 2}, .trial = trial, .source = 3}, first, 16);
}

bool same_column(const PointBlock& a, const PointBlock& b, std::size_t d) {
    return std::equal(a.coordinate[d].begin(), a.coordinate[d].begin() + 16, b.coordinate[d].begin());
}

TEST(Controls, AreMarkedAndFoundByNameOutsideTheCatalogue) {
    ASSERT_FALSE(controls().empty());
    for (const CatalogueEntry& control : controls()) {
        EXPECT_TRUE(control.info.control);
        EXPECT_EQ(find(control.info.name).info.name, control.info.name);
        for (const CatalogueEntry& sampler : catalogue()) {
            EXPECT_FALSE(sampler.info.control);
            EXPECT_NE(sampler.info.name, control.info.name);
        }
    }
}

TEST(PatchCentres, MoveOnlyTheOriginsOfRandomRays) {
    const PointBlock centred = sixteen_points("patch_centres");
    const PointBlock random = sixteen_points("random");
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(centred.coordinate[0][i], 0x80000000u);
        EXPECT_EQ(centred.coordinate[1][i], 0x80000000u);
    }
    EXPECT_TRUE(same_column(centred, random, 2));
    EXPECT_TRUE(same_column(centred, random, 3));
}

TEST(SameSeed, RepeatsItsFirstTrialForever) {
    for (std::size_t d = 0; d < 4; ++d) {
        EXPECT_TRUE(same_column(sixteen_points("same_seed", 7), sixteen_points("random", 0), d));
        EXPECT_FALSE(same_column(sixteen_points("same_seed", 7), sixteen_points("random", 7), d));
    }
}

TEST(SobolFirstDropped, BeginsAtTheSecondPoint) {
    for (std::size_t d = 0; d < 4; ++d)
        EXPECT_TRUE(same_column(sixteen_points("sobol_first_dropped", 0, 5), sixteen_points("sobol", 0, 6), d));
}

TEST(SobolDigitsReversed, IsSobolWithReversedDigits) {
    const PointBlock backwards = sixteen_points("sobol_digits_reversed");
    const PointBlock sobol = sixteen_points("sobol");
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(backwards.coordinate[1][9] >> bit & 1u, sobol.coordinate[1][9] >> (31 - bit) & 1u);
    }
}

}  // namespace
}  // namespace ff::samplers

#include "samplers/sampler.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

// What each control is caught by is shown by tests/contract/broken_samplers.cpp; here, that they are what they say.

namespace ff::samplers {
namespace {

PointBlock points_of(std::string_view name, std::uint32_t trial = 0, PointIndex first = 0) {
    PointBlock block;
    block.size = 16;
    find(name).make({.points = 64})->fill({.key = {1, 2}, .trial = trial, .source = 3}, first, block);
    return block;
}

bool same_column(const PointBlock& a, const PointBlock& b, std::size_t d) {
    return std::equal(a.coordinate[d].begin(), a.coordinate[d].begin() + 16, b.coordinate[d].begin());
}

TEST(Controls, AreFoundByNameAndMarkedAndNotInTheCatalogue) {
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

TEST(PatchCentres, MovesTheOriginsOfRandomRaysAndNothingElse) {
    const PointBlock centred = points_of("patch_centres");
    const PointBlock random = points_of("random");
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(centred.coordinate[0][i], 0x80000000u);
        EXPECT_EQ(centred.coordinate[1][i], 0x80000000u);
    }
    EXPECT_TRUE(same_column(centred, random, 2));
    EXPECT_TRUE(same_column(centred, random, 3));
}

TEST(SameSeed, RepeatsItsFirstTrialForever) {
    for (std::size_t d = 0; d < 4; ++d) {
        EXPECT_TRUE(same_column(points_of("same_seed", 7), points_of("random", 0), d));
        EXPECT_FALSE(same_column(points_of("same_seed", 7), points_of("random", 7), d));
    }
}

TEST(SobolFirstDropped, BeginsAtTheSecondPoint) {
    for (std::size_t d = 0; d < 4; ++d)
        EXPECT_TRUE(same_column(points_of("sobol_first_dropped", 0, 5), points_of("sobol", 0, 6), d));
}

TEST(SobolDigitsReversed, IsSobolWithReversedDigits) {
    const PointBlock backwards = points_of("sobol_digits_reversed");
    const PointBlock sobol = points_of("sobol");
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(backwards.coordinate[1][9] >> bit & 1u, sobol.coordinate[1][9] >> (31 - bit) & 1u);
    }
}

}  // namespace
}  // namespace ff::samplers

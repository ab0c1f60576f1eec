#include "studies/heat/materials.hpp"

#include "core/support/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

using testing::HasSubstr;

const std::vector<std::string> room{"floor", "ceiling", "wall_north", "wall_south"};

std::string refusal(std::string_view toml) {
    try {
        read_materials(toml, "m.toml", room);
    } catch (const UserError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Materials, ANameGoesBeforeAPattern) {
    const auto materials = read_materials(R"(
surroundings = 290
[materials]
"wall*" = { emissivity = 0.9, flux = 0 }
wall_south = { emissivity = 0.5, temperature = 350 }
ceiling = { emissivity = 1, temperature = 300 }
floor = { emissivity = 0.8, flux = 12.5 }
)",
                                          "m.toml", room);
    EXPECT_EQ(materials.faces[2].flux, 0);
    EXPECT_EQ(materials.faces[3].temperature, 350);
    EXPECT_EQ(materials.faces[0].flux, 12.5);
    EXPECT_EQ(materials.surroundings, 290);
    EXPECT_FALSE(materials.are_light());
    EXPECT_THAT(materials.warnings, testing::IsEmpty());
}

TEST(Materials, ThatAreWrongAreRefusedByName) {
    EXPECT_THAT(refusal("[materials]\nfloor = { emissivity = 0.5, flux = 0 }\n"),
                HasSubstr("face 'ceiling' has no material"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0.5, flux = 0 }\nflor = { emissivity = 1, flux = 0 }\n"),
                HasSubstr("Did you mean 'floor'?"));
    EXPECT_THAT(
        refusal("[materials]\n\"*\" = { emissivity = 0.5, flux = 0 }\n\"wall*\" = { emissivity = 1, flux = 0 }\n"),
        HasSubstr("is both"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0, flux = 0 }\n"), HasSubstr("m.toml:2:"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 1.5, flux = 0 }\n"), HasSubstr("above 0, at most 1"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0.5 }\n"), HasSubstr("neither temperature nor flux"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0.5, flux = 0, temperature = 3 }\n"),
                HasSubstr("not both"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0.5, temperature = -3 }\n"), HasSubstr("never negative"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { reflectance = 1 }\n"), HasSubstr("below 1"));
    EXPECT_THAT(refusal("[materials]\n\"*\" = { reflectance = 0.1 }\nfloor = { emissivity = 0.5, flux = 0 }\n"),
                HasSubstr("one system has one kind"));
    EXPECT_THAT(refusal("floor = 1\n"), HasSubstr("m.toml:1"));
    EXPECT_THAT(refusal("surroundings = 300\n"), HasSubstr("materials"));
}

TEST(Materials, WarnOfDegreesCelsius) {
    const auto materials =
        read_materials("[materials]\n\"*\" = { emissivity = 0.5, temperature = 20 }\n", "m.toml", room);
    ASSERT_EQ(materials.warnings.size(), 1u);
    EXPECT_THAT(materials.warnings[0], HasSubstr("293.15 K"));
}

}  // namespace
}  // namespace ff::studies

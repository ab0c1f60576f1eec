#include "studies/heat/materials.hpp"

#include "core/support/error.hpp"
#include "studies/scene_files/scene_with_materials.hpp"
#include "tests/support/known_flows.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies::heat {
namespace {

using testing::HasSubstr;

const std::vector<std::string> room_faces{"floor", "ceiling", "wall_north", "wall_south"};

std::string refusal_of_materials(std::string_view toml) {
    return test::message_of<UserError>([&] { read_materials(toml, "m.toml", {room_faces, {}}); });
}

TEST(Materials, PreferANameToAPattern) {
    const auto materials = read_materials(R"(
surroundings = 290
[materials]
"wall*" = { emissivity = 0.9, flux = 0 }
wall_south = { emissivity = 0.5, temperature = 350 }
ceiling = { emissivity = 1, temperature = 300 }
floor = { emissivity = 0.8, flux = 12.5 }
)",
                                          "m.toml", {room_faces, {}});
    EXPECT_EQ(materials.faces[2].flux, 0);
    EXPECT_EQ(materials.faces[3].temperature, 350);
    EXPECT_EQ(materials.faces[0].flux, 12.5);
    EXPECT_EQ(materials.surroundings, 290);
    EXPECT_FALSE(materials.are_light());
    EXPECT_THAT(materials.warnings, testing::IsEmpty());
}

TEST(Materials, AreRefusedByNameWhenWrong) {
    EXPECT_THAT(refusal_of_materials("[materials]\nfloor = { emissivity = 0.5, flux = 0 }\n"),
                HasSubstr("face 'ceiling' has no material"));
    EXPECT_THAT(refusal_of_materials(
                    "[materials]\n\"*\" = { emissivity = 0.5, flux = 0 }\nflor = { emissivity = 1, flux = 0 }\n"),
                HasSubstr("Did you mean 'floor'?"));
    EXPECT_THAT(refusal_of_materials(
                    "[materials]\n\"*\" = { emissivity = 0.5, flux = 0 }\n\"wall*\" = { emissivity = 1, flux = 0 }\n"),
                HasSubstr("is both"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 0, flux = 0 }\n"), HasSubstr("m.toml:2:"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 0.5, temperature = 1e200 }\n"),
                HasSubstr("1e-9 to 1e9 K"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { reflectance = 0.5, emission = 1e-310 }\n"),
                HasSubstr("1e-60 to 1e60"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 1.5, flux = 0 }\n"),
                HasSubstr("from 1e-9 to 1"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 0.5 }\n"),
                HasSubstr("neither temperature nor flux"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 0.5, flux = 0, temperature = 3 }\n"),
                HasSubstr("not both"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { emissivity = 0.5, temperature = -3 }\n"),
                HasSubstr("never negative"));
    EXPECT_THAT(refusal_of_materials("[materials]\n\"*\" = { reflectance = 1 }\n"), HasSubstr("below 1"));
    EXPECT_THAT(
        refusal_of_materials("[materials]\n\"*\" = { reflectance = 0.1 }\nfloor = { emissivity = 0.5, flux = 0 }\n"),
        HasSubstr("one system has one kind"));
    EXPECT_THAT(refusal_of_materials("floor = 1\n"), HasSubstr("m.toml:1"));
    EXPECT_THAT(refusal_of_materials("surroundings = 300\n"), HasSubstr("materials"));
}

/// Two boxes of one polygon each would be enough: only names matter.
constexpr const char* tiles_obj = R"(
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
g floor
usemtl brick
f 1 2 3 4
g ceiling
usemtl steel
f 5 8 7
usemtl glass
f 5 7 6
g wall
usemtl brick
f 1 5 6 2
)";

SceneWithMaterials scene_of(const std::string& name, std::string_view text) {
    return make_scene_with_materials(source_of_file(name, text));
}

TEST(Materials, AreFoundByTheNamesOfUsemtl) {
    const auto [scene, said, scale] = scene_of("tiles.obj", tiles_obj);
    const auto read = [&scene = scene, &said = said](const char* toml) {
        return read_materials(toml, "m.toml", {scene.faces, said});
    };
    const auto materials = read(R"(
[materials]
brick = { emissivity = 0.9, temperature = 300 }
wall = { emissivity = 0.5, temperature = 400 }
"*" = { emissivity = 0.1, temperature = 500 }
)");
    EXPECT_EQ(materials.faces[0].emissivity, 0.9) << "by its material";
    EXPECT_EQ(materials.faces[1].emissivity, 0.1) << "by the pattern";
    EXPECT_EQ(materials.faces[2].emissivity, 0.5) << "its own name goes first";
    EXPECT_THAT(
        [&] {
            read(
                "[materials]\nsteel = { emissivity = 0.3, flux = 0 }\n\"*\" = { emissivity = 0.1, temperature = 5 }\n");
        },
        testing::ThrowsMessage<UserError>(HasSubstr("face 'ceiling' has the materials 'steel', 'glass'")));
    EXPECT_THAT([&] { read("[materials]\nbrik = { emissivity = 0.3, flux = 0 }\n"); },
                testing::ThrowsMessage<UserError>(HasSubstr("Did you mean 'brick'?")));
}

TEST(Materials, BecomeFacesOnRequest) {
    const Scene scene = scene_of("tiles.obj", with_obj_comment(tiles_obj, "faces material")).scene;
    EXPECT_THAT(scene.faces, testing::ElementsAre("brick", "steel", "glass"));
    EXPECT_EQ(scene.surfaces.size(), 4u);
}

constexpr const char* emitting_plates_vs3 = R"(
F 3
V 1 0 0 0
V 2 1 0 0
V 3 1 1 0
V 4 0 1 0
V 5 0 0 1
V 6 1 0 1
V 7 1 1 1
V 8 0 1 1
S 1 1 2 3 4 0 0 0.25 floor
S 2 5 8 7 0 0 0 0.75 ceiling
S 3 5 7 6 0 0 2 EMISSIVITY ceiling
)";

SceneWithMaterials plates_of_emissivity(const std::string& emissivity) {
    std::string text = emitting_plates_vs3;
    text.replace(text.find("EMISSIVITY"), std::string_view("EMISSIVITY").size(), emissivity);
    return scene_of("plates.vs3", text);
}

TEST(Materials, ReadTheEmissivitiesOfView3d) {
    constexpr const char* toml =
        "surroundings = 0\n[materials]\nfloor = { temperature = 300 }\nceiling = { temperature = 400 }\n";
    const auto read = [](const SceneWithMaterials& made, const char* text) {
        return read_materials(text, "m.toml", {made.scene.faces, made.materials});
    };
    const auto materials = read(plates_of_emissivity("0.75"), toml);
    EXPECT_EQ(materials.faces[0].emissivity, 0.25);
    EXPECT_EQ(materials.faces[1].emissivity, 0.75);
    EXPECT_THAT([&] { read(plates_of_emissivity("0.5"), toml); },
                testing::ThrowsMessage<UserError>(HasSubstr("face 'ceiling' has no emissivity (the scene file gives "
                                                            "its surfaces different ones)")));
    EXPECT_EQ(read(plates_of_emissivity("0.5"), "[materials]\n\"*\" = { emissivity = 1, temperature = 300 }\n")
                  .faces[1]
                  .emissivity,
              1)
        << "the materials file goes first";
}

TEST(Materials, WarnAboutDegreesCelsius) {
    const auto materials =
        read_materials("[materials]\n\"*\" = { emissivity = 0.5, temperature = 20 }\n", "m.toml", {room_faces, {}});
    ASSERT_EQ(materials.warnings.size(), 1u);
    EXPECT_THAT(materials.warnings[0], HasSubstr("293.15 K"));
}

std::vector<Materials> room_cases(std::string_view toml) {
    return read_cases(toml, "m.toml", {room_faces, {}});
}

TEST(FaceGroups, AreTheFacesOfEachEntryUnlessTheFileNamesThem) {
    const std::string sound =
        "[materials]\n\"wall*\" = { emissivity = 0.9, flux = 0 }\nfloor = { emissivity = 0.5, temperature = 300 }\n"
        "ceiling = { emissivity = 0.5, temperature = 300 }\n";
    const auto by_entry = room_cases(sound).front().groups;
    ASSERT_EQ(by_entry.size(), 3u);
    EXPECT_EQ(by_entry[0].name, "floor");
    EXPECT_EQ(by_entry[2].name, "wall*");
    EXPECT_THAT(by_entry[2].faces, testing::ElementsAre(2u, 3u));
    const Materials named = room_cases(sound + "[groups]\nflat = [\"floor\", \"ceil*\"]\nall = \"*\"\n").front();
    EXPECT_TRUE(named.has_named_groups);
    ASSERT_EQ(named.groups.size(), 2u);
    EXPECT_THAT(named.groups[0].faces, testing::SizeIs(4));
    EXPECT_THAT(named.groups[1].faces, testing::ElementsAre(0u, 1u));
    EXPECT_THAT(refusal_of_materials(sound + "[groups]\nflat = [\"flor\"]\n"), HasSubstr("Did you mean 'floor'?"));
}

TEST(HeatCases, ChangeEntriesOfTheFile) {
    const std::string base =
        "surroundings = 290\n[materials]\n\"wall*\" = { emissivity = 0.9, flux = 0 }\n"
        "floor = { emissivity = 0.5, temperature = 300 }\nceiling = { emissivity = 0.5, temperature = 300 }\n";
    const auto cases = room_cases(base + R"(
[[case]]
name = "as drawn"
[[case]]
name = "night"
surroundings = 270
[case.materials]
floor = { flux = 0 }
"wall*" = { emissivity = 0.2 }
wall_south = { emissivity = 1, temperature = 280 }
)");
    ASSERT_EQ(cases.size(), 2u);
    EXPECT_EQ(cases[0].name, "as drawn");
    EXPECT_EQ(cases[0].surroundings, 290);
    EXPECT_EQ(cases[0].faces[0].temperature, 300);
    EXPECT_EQ(cases[1].surroundings, 270);
    EXPECT_EQ(cases[1].faces[0].flux, 0);
    EXPECT_FALSE(cases[1].faces[0].temperature);
    EXPECT_EQ(cases[1].faces[0].emissivity, 0.5);
    EXPECT_EQ(cases[1].faces[1].temperature, 300);
    EXPECT_EQ(cases[1].faces[2].emissivity, 0.2);
    EXPECT_EQ(cases[1].faces[2].flux, 0);
    EXPECT_EQ(cases[1].faces[3].temperature, 280);
    const auto refused = [&](const std::string& more) { return refusal_of_materials(base + more); };
    EXPECT_THAT(refused("[[case]]\n"), HasSubstr("name"));
    EXPECT_THAT(refused("[[case]]\nname = \"a\"\n[[case]]\nname = \"a\"\n"), HasSubstr("two cases"));
    EXPECT_THAT(refused("[[case]]\nname = \"a\"\n[case.materials]\nflor = { emissivity = 1, flux = 0 }\n"),
                HasSubstr("Did you mean 'floor'?"));
    EXPECT_THAT(refused("[[case]]\nname = \"a\"\n[case.materials]\nfloor = { temperature = 9, flux = 0 }\n"),
                HasSubstr("not both"));
    EXPECT_THAT(refused("[[case]]\nname = \"a\"\n[case.materials]\nfloor = { reflectance = 0.5 }\n"),
                HasSubstr("Leave one kind out"));
}

}  // namespace
}  // namespace ff::studies::heat

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Corners = std::vector<std::array<double, 3>>;

const std::string old_rules = "Version,9.5;\nGlobalGeometryRules, UpperLeftCorner, Counterclockwise, World;\n";
const std::string relative_rules = "VERSION,9.6;\nglobalgeometryrules,ULC,CCW,Relative;\n";

/// The walls of a room of 4 x 3 x 2.5, counter-clockwise as seen from outside.
const std::array<std::pair<std::string, Corners>, 6> walls_of_room{{
    {"floor", {{0, 3, 0}, {4, 3, 0}, {4, 0, 0}, {0, 0, 0}}},
    {"roof", {{4, 0, 2.5}, {4, 3, 2.5}, {0, 3, 2.5}, {0, 0, 2.5}}},
    {"south wall", {{4, 0, 0}, {4, 0, 2.5}, {0, 0, 2.5}, {0, 0, 0}}},
    {"east", {{4, 3, 0}, {4, 3, 2.5}, {4, 0, 2.5}, {4, 0, 0}}},
    {"north", {{0, 3, 0}, {0, 3, 2.5}, {4, 3, 2.5}, {4, 3, 0}}},
    {"west", {{0, 0, 0}, {0, 0, 2.5}, {0, 3, 2.5}, {0, 3, 0}}},
}};
/// These as faces of the built-in box.
const std::array<std::size_t, 6> faces_of_box{0, 5, 1, 3, 2, 4};

const Corners pane{{3, 0, 1}, {3, 0, 2}, {1, 0, 2}, {1, 0, 1}};

std::string list_of(const Corners& corners) {
    std::string text;
    for (const auto& [x, y, z] : corners) text += fmt::format(",\n  {}, {}, {}", x, y, z);
    return text + ";\n";
}

/// @param space  empty before version 9.6; " ," for a blank field from then on
std::string wall(const std::string& name, const std::string& zone, const Corners& corners,
                 const std::string& space = "", const std::string& boundary = "Outdoors,") {
    return fmt::format("BuildingSurface:Detailed,\n  {}, Wall, Brick, {},{} {}, SunExposed, WindExposed, , {}{}", name,
                       zone, space, boundary, corners.size(), list_of(corners));
}

std::string window(const std::string& base, const std::string& multiplier = "1", const Corners& corners = pane) {
    return fmt::format("FENESTRATIONSURFACE:DETAILED, Pane, Window, Glass, {}, , , , {}, autocalculate{}", base,
                       multiplier, list_of(corners));
}

std::string walls(const std::string& zone, const std::string& space = "") {
    std::string text;
    for (const auto& [name, corners] : walls_of_room) text += wall(name, zone, corners, space);
    return text;
}

std::string room() {
    return old_rules + "Zone, Zone One;  ! a comment, with ; and ,\n" + walls("ZONE ONE");
}

std::string room_as_json() {
    std::string surfaces;
    for (const auto& [name, corners] : walls_of_room) {
        std::string vertices;
        for (const auto& [x, y, z] : corners)
            vertices +=
                fmt::format(R"({}{{"vertex_x_coordinate": {}, "vertex_y_coordinate": {}, "vertex_z_coordinate": {}}})",
                            vertices.empty() ? "" : ", ", x, y, z);
        surfaces +=
            fmt::format("{}\n\"{}\": {{\"zone_name\": \"Zone One\", \"number_of_vertices\": 4, \"vertices\": [{}]}}",
                        surfaces.empty() ? "" : ",", name, vertices);
    }
    return R"({"Version": {"Version 1": {"version_identifier": "24.1"}},
"GlobalGeometryRules": {"GlobalGeometryRules 1": {"coordinate_system": "Relative",
 "starting_vertex_position": "UpperLeftCorner", "vertex_entry_direction": "Counterclockwise"}},
"Zone": {"Zone One": {"x_origin": 7}}, "People": {"somebody": {}},
"Shading:Site:Detailed": {"tree": {"vertices": [1]}},
"BuildingSurface:Detailed": {)" +
           surfaces + R"(},
"FenestrationSurface:Detailed": {"Pane": {"building_surface_name": "South Wall",
 "vertex_1_x_coordinate": 3, "vertex_1_y_coordinate": 0, "vertex_1_z_coordinate": 1,
 "vertex_2_x_coordinate": 3, "vertex_2_y_coordinate": 0, "vertex_2_z_coordinate": 2,
 "vertex_3_x_coordinate": 1, "vertex_3_y_coordinate": 0, "vertex_3_z_coordinate": 2}}})";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
}

Scene read_zone(const std::string& text, const std::string& title = "room.idf") {
    return make_scene(source_of_file(title, text));
}

std::string refusal(const std::string& text, const std::string& title = "room.idf") {
    try {
        read_zone(text, title);
        return "";
    } catch (const UserError& error) {
        return error.what();
    }
}

void expect_room(const Scene& scene) {
    EXPECT_TRUE(scene.closed);
    EXPECT_THAT(doubts_about(scene), IsEmpty());
    const auto found = form_factors::find_matrix(scene, {});
    const auto box = form_factors::find_matrix(make_scene("box:4x3x2.5"), {});
    ASSERT_EQ(found.faces(), box.faces());
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j)
            EXPECT_NEAR(found.exchange(i, j).value, box.exchange(faces_of_box.at(i), faces_of_box.at(j)).value, 1e-12)
                << scene.faces[i] << ' ' << scene.faces[j];
    }
}

TEST(EnergyPlusFiles, HaveTheFactorsOfTheBoxThatTheyDescribe) {
    const Scene scene = read_zone(room());
    EXPECT_EQ(scene.name, "room.idf zone:Zone One");
    EXPECT_THAT(scene.faces, ElementsAre("floor", "roof", "south wall", "east", "north", "west"));
    EXPECT_THAT(scene.remarks, IsEmpty());
    expect_room(scene);
}

TEST(EnergyPlusFiles, MayGoRoundClockwiseAndHaveSpacesFromVersion96On) {
    std::string text = "Version,24.2;\nGlobalGeometryRules, UpperLeftCorner, Clockwise, World;\nZone,Z;Space,S,Z;";
    for (auto [name, corners] : walls_of_room) {
        std::reverse(corners.begin(), corners.end());
        text += replaced(wall(name, "Z", corners, " S,"), ", 4,", ", ,");
    }
    expect_room(read_zone(text, "ROOM.IDF"));
    EXPECT_EQ(read_zone(text, "ROOM.IDF zone:s").name, "ROOM.IDF zone:S");
    EXPECT_THAT(refusal(replaced(text, "24.2", "9.5")), HasSubstr("fields moved in 9.0 and 9.6"));
}

TEST(EnergyPlusFiles, MayDivideWallsRoofsAndFloors) {
    const std::string text =
        replaced(replaced(room(), "BuildingSurface:Detailed,\n  floor, Wall,", "Floor:Detailed, floor,"),
                 "BuildingSurface:Detailed,\n  roof, Wall,", "ROOFCEILING:DETAILED, roof,");
    expect_room(read_zone(text));
}

TEST(EnergyPlusFiles, MayBeEpJson) {
    const Scene scene = read_zone(room_as_json(), "room.epJSON");
    EXPECT_EQ(scene.name, "room.epJSON zone:Zone One");
    EXPECT_THAT(scene.faces, ElementsAre("floor", "roof", "south wall", "Pane", "east", "north", "west"));
    EXPECT_NEAR(face_area(scene, 3), 1, 1e-14);
    EXPECT_NEAR(face_area(scene, 2), 9, 1e-13);
    expect_room(read_zone(replaced(room_as_json(), "FenestrationSurface:Detailed", "Lights"), "room.epjson"));
}

TEST(EnergyPlusFiles, HaveWindowsCutOutOfTheirWalls) {
    const Scene scene =
        read_zone(replaced(room(), "9.5", "8.9") + replaced(window("SOUTH wall"), ", , , ,", ", , , , ,"));
    EXPECT_THAT(doubts_about(scene), IsEmpty());
    ASSERT_THAT(scene.faces, ElementsAre("floor", "roof", "south wall", "Pane", "east", "north", "west"));
    EXPECT_NEAR(face_area(scene, 2), 8, 1e-13);
    EXPECT_NEAR(face_area(scene, 3), 2, 1e-13);
    const auto matrix = form_factors::find_matrix(scene, {});
    for (std::size_t i = 0; i < 7; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < 7; ++j) sum += matrix.exchange(i, j).value / matrix.areas[i];
        EXPECT_NEAR(sum, 1, 1e-9) << scene.faces[i];
    }
}

TEST(EnergyPlusFiles, HaveWindowsInNonConvexWalls) {
    const Corners corner_wall{{4, 0, 0}, {4, 0, 2.5}, {3, 0, 2.5}, {3, 0, 1}, {0, 0, 1}, {0, 0, 0}};
    const std::string zone = old_rules + "Zone,Z;" + wall("L", "Z", corner_wall);
    const Scene scene = read_zone(zone + window("L", "", {{3.8, 0, 0.5}, {3.8, 0, 2}, {3.2, 0, 2}, {3.2, 0, 0.5}}));
    EXPECT_NEAR(face_area(scene, 0), 5.5 - 0.9, 1e-12);
    EXPECT_THAT(refusal(zone + window("L")), HasSubstr("'Pane' reaches beyond 'L', its base"));
}

// On the south wall, whose diagonal is 4.7: up to 0.0094 is corrected.
TEST(EnergyPlusFiles, HaveWindowsThatRoundingPutsOffTheirWalls) {
    const auto with_pane = [](const Corners& corners) { return room() + window("south wall", "1", corners); };
    const Scene moved = read_zone(with_pane({{3, 0.004, 1}, {3, 0.004, 2}, {1, 0.004, 2}, {1, 0.004, 1}}));
    EXPECT_THAT(moved.remarks, ElementsAre(HasSubstr("a window or door is 0.004 off its wall, and is put into its "
                                                     "plane and outline (line 40)")));
    EXPECT_NEAR(face_area(moved, 2), 8, 1e-12);
    EXPECT_NEAR(face_area(moved, 3), 2, 1e-12);
    EXPECT_THAT(doubts_about(moved), testing::SizeIs(1));
    const Corners low_door{{2, 0, -0.003}, {2, 0, 2}, {1, 0, 2}, {1, 0, -0.003}};
    const Scene cut = read_zone(with_pane(low_door));
    EXPECT_THAT(cut.remarks, ElementsAre(HasSubstr("a window or door is 0.003 off its wall")));
    EXPECT_NEAR(face_area(cut, 3), 2, 1e-12);
    const Scene several =
        read_zone(with_pane(low_door) +
                  replaced(window("north", "1", {{3, 2.999, 1}, {1, 2.999, 1}, {1, 2.999, 2}}), "Pane", "Other"));
    EXPECT_THAT(several.remarks, ElementsAre(HasSubstr("2 windows and doors are up to 0.003 off their walls, and are "
                                                       "put into their planes and outlines (the first in line 40)")));
    EXPECT_THAT(refusal(with_pane({{3, 0.02, 1}, {3, 0.02, 2}, {1, 0.02, 2}, {1, 0.02, 1}})),
                HasSubstr("'Pane' does not lie in the plane of 'south wall', its base (it is 0.02 off; up to 0.0094 "
                          "counts as rounding)"));
    EXPECT_THAT(refusal(with_pane({{2, 0, -0.02}, {2, 0, 2}, {1, 0, 2}, {1, 0, -0.02}})),
                HasSubstr("'Pane' reaches beyond 'south wall', its base (it is 0.02 off"));
}

TEST(EnergyPlusFiles, HaveWindowsWithThreeDecimalsInSlopedRoofs) {
    const std::string zone =
        old_rules + "Zone,Z;" + wall("roof", "Z", {{5, 0, 2.4}, {5, 4, 3.7}, {0, 4, 3.7}, {0, 0, 2.4}});
    const Scene scene =
        read_zone(zone + window("roof", "1", {{1, 1.11, 2.761}, {2, 1.11, 2.761}, {2, 2.23, 3.125}, {1, 2.23, 3.125}}));
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("a window or door is 0.00024 off its wall")));
    EXPECT_NEAR(face_area(scene, 0) + face_area(scene, 1), 5 * std::hypot(4, 1.3), 1e-9);
}

TEST(EnergyPlusFiles, MayLackTheirVersion) {
    const std::string text = replaced(room(), "Version,9.5;\n", "");
    const std::string said = "no Version object: fields are taken as those of version 9.6 and later";
    EXPECT_THAT(refusal(text), HasSubstr(said));
    const std::string new_text = "GlobalGeometryRules, ULC, CCW, World;\nZone,Zone One;" + walls("ZONE ONE", " ,");
    EXPECT_THAT(read_zone(new_text).remarks, ElementsAre(said));
    EXPECT_THAT(read_zone(replaced(room_as_json(), "Version", "People 2"), "a.epJSON").remarks, IsEmpty());
}

TEST(EnergyPlusFiles, MayHaveATransformationThatChangesNothing) {
    EXPECT_THAT(read_zone(room() + "GeometryTransform, XY, 2, 2;").remarks, IsEmpty());
    EXPECT_THAT(refusal(room() + "GeometryTransform, XY, 0.5, 2;"),
                HasSubstr(":40: GeometryTransform changes the aspect ratio from 0.5 to 2 (vertices are taken as they"));
}

/// Two rooms side by side, one of them turned; the wall between them is described once.
TEST(EnergyPlusFiles, HaveTurnedZonesThatShareWalls) {
    std::string text = relative_rules + "Zone, Left, 30, 1, 2, 3; Zone, Right, 120, 2, 2, 3;\n";
    text += walls("Left", " ,");
    // Left's east wall in Right's coordinates: moved by the origins' difference, and turned back by 90 degrees.
    Corners shared;
    for (const auto& [x, y, z] : walls_of_room[3].second) {
        const double c = 0.86602540378443865, s = 0.5;
        const double across = x - c, along = y - s;
        shared.insert(shared.begin(), {-along, across, z});
    }
    const auto at = text.find("BuildingSurface:Detailed,\n  east"),
               end = text.find("BuildingSurface:Detailed,\n  north");
    text.replace(at, end - at, wall("shared", "Right", shared, " ,", "Zone, LEFT"));
    Scene scene = read_zone(text, "room.idf zone:left");
    EXPECT_EQ(scene.name, "room.idf zone:Left");
    EXPECT_EQ(scene.faces[3], "iz-shared");
    expect_room(scene);
    EXPECT_THAT(read_zone(text, "room.idf zone:Right").faces, ElementsAre("shared"));
    EXPECT_THAT(refusal(text),
                AllOf(HasSubstr("room.idf: 2 zones"), HasSubstr("'Left', 'Right'"), HasSubstr("Choose by --zone")));
    EXPECT_THAT(refusal(text, "room.idf zone:Attic"),
                HasSubstr("no zone or space is called 'Attic'. Zones are 'Left', 'Right'."));
}

TEST(EnergyPlusFiles, GetRemarksOnIgnoredObjectsAndFields) {
    const std::string more = "InternalMass, desks, Wood, Zone One, , 20;\nConstruction:AirBoundary, Brick, None;\n" +
                             replaced(window("south wall"), ", , , , 1", ", , , Frame, 1");
    const auto remarks = read_zone(room() + more).remarks;
    EXPECT_THAT(remarks, Contains(HasSubstr("an internal mass has no geometry")));
    EXPECT_THAT(remarks, Contains(HasSubstr("a frame of a window counts as a part of its wall")));
    EXPECT_THAT(remarks, Contains(HasSubstr("6 surfaces are air boundaries")));
}

TEST(EnergyPlusFiles, AreRefusedWithTheirLine) {
    const std::string whole = room();
    const auto last_line = std::count(whole.begin(), whole.end(), '\n') + 1;
    const std::string json = room_as_json();
    for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
             {whole.substr(0, whole.size() - 3), ":34: no semicolon ends the object 'BuildingSurface:Detailed'"},
             {whole + "Roof, old, Brick, Zone One;",
              "'old' is of the class roof (only surfaces with vertices are read)"},
             {replaced(whole, ", 4,", ", 400000000000,"),
              ":5: 'floor' has 4 vertices, and '400000000000' are announced"},
             {replaced(whole, ", 4,", ", 2,"), "'2' are announced"},
             {whole + wall("line", "zone one", {{0, 0, 0}, {1, 0, 0}}), "'line' has 2 vertices (a surface has three"},
             {replaced(whole, ";\nBuilding", ", 1;\nBuilding"), "'floor' has 13 coordinates (a vertex has three)"},
             {replaced(whole, "4, 3, 0", "4, nan, 0"), ":7: a coordinate is 'nan', not a finite number"},
             {replaced(whole, "4, 3, 0", "4, , 0"), "a coordinate is blank"},
             {whole + window("soth wall"),
              fmt::format(":{}: 'Pane' lies on 'soth wall', which is not a wall", last_line)},
             {whole + window("south wall", "3"), "'Pane' stands for 3 windows"},
             {whole + window("roof"), "'Pane' does not lie in the plane of 'roof', its base"},
             {whole + wall("Floor", "zone one", pane), "surface 'Floor' is defined twice"},
             {whole + wall("attic", "zone two", pane), "zone 'zone two' is not defined"},
             {whole + "Zone,zone one;", "zone 'zone one' is defined twice"},
             {replaced(whole, "Zone, Zone One", "Zones, Zone One"), "room.idf: no zone"},
             {replaced(whole, "GlobalGeometryRules", "Rules"), "no GlobalGeometryRules"},
             {replaced(whole, "Counterclockwise", "Upwards"), ":2: vertex entry direction 'Upwards' is unknown"},
             {replaced(whole, "World", "Moon"), "coordinate system 'Moon' is unknown"},
             {"##include other.idf\n" + whole,
              "room.idf:1: '##include' is a directive of EP-Macro (macros are not read)"},
             {replaced(whole, "9.5", "2.2"), ":1: version 2.2 (classes had other names before 3.0)"},
             {replaced(whole, "9.5", "new"), "version 'new' (numbers are wanted)"},
             {old_rules + "Zone,Z;", "zone 'Z' has no surface that is read"},
         })
        EXPECT_THAT(refusal(text), HasSubstr(message));
    EXPECT_THAT(refusal(replaced(room() + window("south wall"), "SURFACE:DETAILED, Pane", "SURFACE:DETAIL, Pane")),
                HasSubstr("class 'FENESTRATIONSURFACE:DETAIL' is unknown"));
    EXPECT_EQ(read_zone(room() + "Pipe:Adiabatic, pipe;\n").faces.size(), 6);
    EXPECT_THAT(refusal(json.substr(0, 900), "a.epJSON"), HasSubstr("this is not JSON"));
    EXPECT_THAT(refusal(replaced(json, "\"west\"", "\"east\""), "a.epJSON"), HasSubstr("stands twice in one object"));
    EXPECT_THAT(refusal(replaced(json, R"("Zone One": {"x_origin": 7})", R"("Zone One": [7])"), "a.epJSON"),
                HasSubstr("'Zone One' is no object"));
    EXPECT_THAT(refusal(std::string(100'000, '['), "a.epJSON"), HasSubstr("objects and lists within each other"));
}

}  // namespace
}  // namespace ff::studies

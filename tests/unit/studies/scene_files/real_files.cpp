#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

// Files from practice: what other programs write, as far as it can be understood in one way only.
namespace ff::studies {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
constexpr const char* cube_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";

Scene read_real(const std::string& name, const std::string& text) {
    return make_scene(source_of_file(name, text));
}

Scene read_cube(const std::string& rest) {
    return read_real("a.obj", cube_vertices + rest);
}

form_factors::Request request_within_a_millionth() {
    form_factors::Request request;
    request.tolerance = 1e-6;
    return request;
}

double factor_of(const Scene& scene, std::size_t from, std::size_t to) {
    const auto matrix = form_factors::find_matrix(scene, request_within_a_millionth());
    return matrix.exchange(from, to).value / matrix.areas[from];
}

TEST(RealObjFiles, HaveEmptyGroupsAndGroupsOfLines) {
    const Scene scene = read_cube("g default\ng wires\nl 1 2\ng floor\nf 1 2 3 4\ng default\n");
    EXPECT_THAT(scene.faces, ElementsAre("floor"));
    EXPECT_THAT(scene.remarks, IsEmpty());
}

TEST(RealObjFiles, ContinueLinesAndLeaveIndicesOut) {
    const Scene scene = read_cube("g floor\nf 1// 2// \\\n 3// \\\n 4//\n");
    ASSERT_EQ(scene.surfaces.size(), 1u);
    EXPECT_DOUBLE_EQ(face_area(scene, 0), 1);
}

TEST(RealObjFiles, MayHaveExtensionsInCapitals) {
    EXPECT_THAT(read_real("A.OBJ", std::string(cube_vertices) + "f 1 2 3 4\n").faces, ElementsAre("1"));
}

TEST(RealObjFiles, HaveFacesByGroupObjectOrMaterial) {
    const std::string of_materials = "o room\nusemtl wood\nf 1 2 3 4\nusemtl stone\nf 5 8 7 6\n";
    const Scene scene = read_cube(of_materials);
    EXPECT_THAT(scene.faces, ElementsAre("wood", "stone"));
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("its faces are its 2 materials")));
    EXPECT_THAT(read_cube(of_materials + "# faces group\n").faces, ElementsAre("room"));
    EXPECT_THAT(read_cube("o a\ng x\nf 1 2 3 4\no b\ng x\nf 5 8 7 6\n").faces, ElementsAre("a", "b"));
    const std::string of_objects = "o low\ng a\nf 1 2 3 4\no high\ng b\nf 5 8 7 6\ng c\nf 1 5 6 2\n";
    EXPECT_THAT(read_cube(of_objects).faces, ElementsAre("a", "b", "c"));
    EXPECT_THAT(read_cube(of_objects + "# faces object\n").faces, ElementsAre("low", "high"));
    EXPECT_THAT(read_cube(of_objects + "# faces polygon\n").faces, ElementsAre("a.1", "b.1", "c.1"));
}

TEST(RealObjFiles, HaveAScaleAndAnAxisThatPointsUp) {
    const std::string floor = "f 1 2 3 4\n";
    const auto box_of = [&](const std::string& comments) {
        return box_around(read_cube(floor + comments).surfaces.front());
    };
    const Eigen::AlignedBox3d plain = box_of("");
    EXPECT_EQ(box_of("# scale 0.001\n").max(), plain.max() / 1000);
    EXPECT_EQ(read_cube(floor).surfaces.front().normal, Eigen::Vector3d(0, 0, 1));
    EXPECT_EQ(read_cube(floor + "# up y\n").surfaces.front().normal, Eigen::Vector3d(0, -1, 0));
    EXPECT_EQ(read_cube(floor + "# up x\n").surfaces.front().normal, Eigen::Vector3d(0, 1, 0));
    EXPECT_EQ(read_cube(floor + "# up z\n").surfaces.front().normal, Eigen::Vector3d(0, 0, 1));
    EXPECT_THAT(read_cube(floor + "# scale 0.001\n# up y\n").remarks,
                ElementsAre("its lengths are multiplied by 0.001", HasSubstr("its y axis")));
    EXPECT_TRUE(read_cube(floor + "# Closed\n").closed);
    // Comments that mean something else are ignored.
    EXPECT_THAT(read_cube(floor + "# scale\n# scale unknown\n# faces 12\n# up there\n").remarks, IsEmpty());
    EXPECT_THAT(read_cube(floor + "# scale -2\n# up -y\n# faces materials\n").remarks,
                testing::Each(HasSubstr("says nothing")));
}

TEST(RealObjFiles, HaveSliversAndDuplicatesWhichAreLeftOut) {
    const Scene scene = read_cube("v 2 0 0\ng floor\nf 1 2 3 4\nf 3 4 1 2\nf 1 2 9\nf 1 1 2\n");
    EXPECT_EQ(scene.surfaces.size(), 1u);
    EXPECT_THAT(scene.remarks, ElementsAre("2 polygons have no area and are left out (lines 13, 14)",
                                           HasSubstr("is a copy of another")));
}

TEST(RealObjFiles, HaveSpikesAndSlitsWhichAreCutOff) {
    for (const std::string polygon : {"1 2 3 9 10 9 4", "10 9 4 1 2 3 9", "1 2 3 9 11 9 4", "1 2 3 9 10 11 9 4"}) {
        EXPECT_NEAR(face_area(read_cube("v 0.5 1 0\nv 0.5 2 0\nv 0.5 0.5 0\nf " + polygon + "\n"), 0), 1, 1e-12);
    }
}

TEST(RealObjFiles, HaveConcaveAndTwistedPolygonsWhichAreDivided) {
    // A floor plan of three unit squares, from each of its corners.
    for (int first = 0; first < 6; ++first) {
        std::string polygon = "f";
        for (int k = 0; k < 6; ++k) polygon += " " + std::to_string(1 + (first + k) % 6);
        const Scene plan =
            read_real("a.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n" + polygon + "\n");
        EXPECT_DOUBLE_EQ(face_area(plan, 0), 3);
        EXPECT_THAT(plan.remarks, ElementsAre("a polygon is not convex and is divided into triangles (line 7)"));
        for (const Surface& surface : plan.surfaces) EXPECT_GT(surface.normal.z(), 0.99);
    }
    const Scene twisted = read_cube("v 0 1.0001 0.01\nf 1 2 3 9\n");
    EXPECT_EQ(twisted.surfaces.size(), 2u);
    EXPECT_THAT(twisted.remarks, ElementsAre(HasSubstr("is not plane")));
}

// A square with a square hole, joined to the rim by a cut that is run through both ways.
TEST(RealObjFiles, HaveHolesBehindACut) {
    const Scene scene = read_real("a.obj",
                                  "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
                                  "f 1 2 3 4 1 5 8 7 6 5\n");
    EXPECT_NEAR(face_area(scene, 0), 8, 1e-12);
}

TEST(RealObjFiles, HaveTwoSidedPlates) {
    const Scene scene = read_cube("g low\nf 1 2 3 4\ng front\nf 5 8 7 6\ng back\nf 6 7 8 5\n");
    EXPECT_THAT(scene.remarks, IsEmpty());
    EXPECT_NEAR(factor_of(scene, 0, 1), 0.19982489569838746, 1e-12);
    EXPECT_EQ(factor_of(scene, 0, 2), 0);
}

/// Two rooms side by side, each closed, with a wall between them that has a side for each.
std::string two_rooms(bool halved) {
    std::string text = "# closed\n";
    for (const int x : {0, 1, 2}) {
        for (const char* yz : {"0 0", "1 0", "1 1", "0 1", "0.5 0", "0.5 1"}) text += fmt::format("v {} {}\n", x, yz);
    }
    const auto room = [&](char name, int low) {  // first vertex of its western end
        const int a = 1 + low, b = 7 + low;
        text += fmt::format("g {0}floor\nf {1} {2} {3} {4}\n", name, a, b, b + 1, a + 1);
        text += fmt::format("g {0}roof\nf {1} {2} {3} {4}\n", name, a + 3, a + 2, b + 2, b + 3);
        text += fmt::format("g {0}south\nf {1} {2} {3} {4}\n", name, a, a + 3, b + 3, b);
        text += fmt::format("g {0}north\nf {1} {2} {3} {4}\n", name, a + 1, b + 1, b + 2, a + 2);
        text += fmt::format("g {0}west\nf {1} {2} {3} {4}\n", name, a, a + 1, a + 2, a + 3);
        text += fmt::format("g {}east\n", name);
        if (halved && name == 'A')
            text += fmt::format("f {} {} {} {}\nf {} {} {} {}\n", b, b + 3, b + 5, b + 4, b + 4, b + 5, b + 2, b + 1);
        else
            text += fmt::format("f {} {} {} {}\n", b, b + 3, b + 2, b + 1);
    };
    room('A', 0);
    room('B', 6);
    return text;
}

// The rooms rise at its rims, not the sides of a body that stands on it.
TEST(RealObjFiles, HaveThinWallsBetweenRooms) {
    for (const bool halved : {false, true}) {
        const Scene scene = read_real("a.obj", two_rooms(halved));
        ASSERT_EQ(scene.faces.size(), 12u);
        EXPECT_THAT(scene.covered, IsEmpty());
        const auto matrix = form_factors::find_matrix(scene, request_within_a_millionth());
        for (std::size_t a = 0; a < 6; ++a) {
            EXPECT_NEAR(matrix.rows[a].value, 1, 1e-9);
            for (std::size_t b = 6; b < 12; ++b) EXPECT_LT(matrix.exchange(a, b).high, 1e-13);
        }
    }
}

// However short the edges that turn back are; a polygon that goes round twice is a star.
TEST(RealObjFiles, HaveConcavePolygonsOfManyCorners) {
    for (const int corners : {40, 1000}) {
        std::string text, polygon = "f";
        for (int k = 0; k < 2 * corners; ++k) {
            const bool back = k >= corners;
            const double angle = std::numbers::pi * (back ? k - corners : corners - k) / corners;
            text += fmt::format("v {} {} 0\n", (back ? 0.5 : 1) * std::sin(angle), std::cos(angle));
            polygon += fmt::format(" {}", k + 1);
        }
        const Scene scene = read_real("a.obj", text + polygon + "\n");
        EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("is not convex")));
        EXPECT_NEAR(face_area(scene, 0), std::numbers::pi / 4, 4.0 / corners / corners) << corners;
    }
    std::string star;
    for (int k = 0; k < 5; ++k)
        star += fmt::format("v {} {} 0\n", std::cos(0.8 * std::numbers::pi * k), std::sin(0.8 * std::numbers::pi * k));
    EXPECT_THROW(read_real("a.obj", star + "f 1 2 3 4 5\n"), UserError);
}

TEST(RealObjFiles, HaveObjectsAsOccludersAndNamesWithBlanks) {
    const Scene scene = read_cube(
        "o occluder\ng wall\nf 1 2 3 4 # a comment\no room\nusemtl white paint\nf 5 8 7 6\n"
        "usemtl white brick\nf 1 5 6 2\n# faces material\n");
    EXPECT_THAT(scene.faces, ElementsAre("white paint", "white brick"));
    EXPECT_EQ(scene.surfaces[0].face, no_face);
}

TEST(RealObjFiles, MayCallAFaceAll) {
    EXPECT_THAT(read_cube("g all\nf 1 2 3 4\ng all.2\nf 5 8 7 6\n").faces.size(), 2u) << "they stay apart";
    const Scene scene = read_cube("g all\nf 1 2 3 4\ng sum\nf 5 8 7 6\n");
    EXPECT_THAT(scene.faces, ElementsAre("all.2", "sum.2"));
    EXPECT_EQ(scene.remarks.size(), 2u);
}

// Wherever the odd one is, and whichever way the majority faces.
TEST(Winding, IsThatOfTheMajorityOfAFace) {
    const std::string strip = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\ng strip\n";
    const char* up[] = {"f 1 2 6 5\n", "f 2 3 7 6\n", "f 3 4 8 7\n"};
    const char* down[] = {"f 5 6 2 1\n", "f 6 7 3 2\n", "f 7 8 4 3\n"};
    for (int odd = 0; odd < 3; ++odd) {
        std::string mostly_up = strip, mostly_down = strip;
        for (int k = 0; k < 3; ++k) {
            mostly_up += k == odd ? down[k] : up[k];
            mostly_down += k == odd ? up[k] : down[k];
        }
        for (const auto& [text, z] : {std::pair(mostly_up, 1.0), std::pair(mostly_down, -1.0)}) {
            const Scene scene = read_real("a.obj", text);
            for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.normal.z(), z);
            EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("wound in the opposite direction")));
        }
    }
}

TEST(Winding, IsDecidedByVisibilityWhereHalvesAreEqual) {
    const Scene scene = read_cube("g lower\nf 1 2 3 4\ng upper\nf 5 7 6\nf 5 7 8\n");
    EXPECT_NEAR(factor_of(scene, 0, 1), 0.19982489569838746, 1e-12);
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("(line 13)")));
    const Scene alone = read_cube("g upper\nf 5 7 6\nf 5 7 8\n");
    EXPECT_THAT(alone.remarks, IsEmpty());
    EXPECT_THAT(examine_scene(alone).faults, ElementsAre(HasSubstr("face 'upper' meet in an edge")));
}

TEST(Winding, IsLeftAloneOnBodiesAndThinPlates) {
    const Scene scene = read_cube("g all_of_it\nf 1 2 3 4\nf 4 3 2 1\nf 1 5 6 2\n");
    EXPECT_THAT(scene.remarks, IsEmpty());
    EXPECT_EQ(scene.surfaces[0].normal.z(), 1);
    EXPECT_EQ(scene.surfaces[1].normal.z(), -1);
}

// Four sides meet at an edge of two bodies that touch there, two of each face: they are right as they are.
TEST(Winding, IsLeftAloneWhereBodiesTouch) {
    const Scene scene = read_real("a.obj",
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
                                  "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 2 1 1\nv 2 2 1\nv 1 2 1\n"
                                  "g ew\nf 2 3 10 9\nf 4 1 8 11\nf 5 6 13 12\nf 7 3 10 14\n"
                                  "g ns\nf 1 2 9 8\nf 3 4 11 10\nf 3 5 12 10\nf 6 7 14 13\n");
    EXPECT_THAT(scene.remarks, IsEmpty());
}

TEST(Winding, IsFoundDespiteDuplicates) {
    const Scene scene = read_cube("g low\nf 1 2 3\nf 1 2 3\nf 3 1 4\nf 1 4 3\nf 1 4 3\ng high\nf 5 8 7 6\n");
    for (std::size_t s = 0; s < 2; ++s) EXPECT_EQ(scene.surfaces[s].normal.z(), 1) << s;
}

TEST(Winding, IsDoubtedWhereTwoFacesOfAnOpenSceneDisagree) {
    EXPECT_THAT(examine_scene(read_cube("g floor\nf 4 3 2 1\ng side\nf 1 5 6 2\n")).notes,
                testing::Contains(HasSubstr("faces 'floor' and 'side' run through a common edge")));
}

constexpr const char* room_vs3 =
    "F 3\nV 1 0 0 0\nV 2 3 0 0\nV 3 3 4 0\nV 4 0 4 0\nV 5 0 0 2\nV 6 3 0 2\nV 7 3 4 2\nV 8 0 4 2\n"
    "V 9 1 1 0\nV 10 2 1 0\nV 11 2 2 0\nV 12 1 2 0\n"
    "S 1 1 2 3 4 0 0 0.9 floor\nS 2 5 8 7 6 0 0 0.9 roof\nS 3 1 5 6 2 0 0 0.9 wall\nS 4 2 6 7 3 0 0 0.9 wall\n"
    "S 5 3 7 8 4 0 0 0.9 wall to the north ! and a comment\nS 6 4 8 5 1 0 0 0.9\n";

Scene read_room(const std::string& rest) {
    return read_real("a.vs3", room_vs3 + rest);
}

TEST(RealVs3Files, GiveEverySurfaceAFaceOfItsOwn) {
    const Scene scene = read_room("C encl =  1  list =  2, eps=1e-4 maxu = 8\n");
    EXPECT_THAT(scene.faces, ElementsAre("floor", "roof", "wall", "wall.2", "wall to the north", "6"));
    EXPECT_TRUE(scene.closed);
    EXPECT_THAT(scene.remarks, IsEmpty());
    EXPECT_FALSE(read_room("c ENCL=0\n").closed);
    EXPECT_THAT(read_room("C enclosure=1\n").remarks, ElementsAre(HasSubstr("'enclosure' (line 20) is unknown")));
}

TEST(RealVs3Files, PutWindowsOnWalls) {
    const Scene scene = read_room("C encl=1\nS 7 9 10 11 12 1 0 0.8 hatch\n");
    EXPECT_DOUBLE_EQ(face_area(scene, 0), 11);
    EXPECT_DOUBLE_EQ(face_area(scene, 6), 1);
    EXPECT_NEAR(factor_of(scene, 0, 1) * 11 + factor_of(scene, 6, 1), factor_of(read_room(""), 0, 1) * 12, 1e-10);
    const Scene glass = read_room("C encl=1\nS 7 5 8 7 6 2 0 0.8 glass\n");
    EXPECT_THAT(glass.faces, ElementsAre("floor", "wall", "wall.2", "wall to the north", "6", "glass"));
    EXPECT_THAT(glass.remarks, ElementsAre("what lies on 'roof' leaves nothing of it; it is no face"));
    EXPECT_THROW(read_room("S 7 12 11 10 9 1 0 0.8 hatch\n"), UserError) << "it faces the other way";
    EXPECT_THROW(read_room("S 7 9 10 11 12 2 0 0.8 hatch\n"), UserError) << "it lies elsewhere";
    const Scene rounded = read_room("C encl=1\nV 13 2 1 0.003\nS 7 9 13 11 12 1 0 0.8 hatch\n");
    EXPECT_THAT(rounded.remarks, ElementsAre(HasSubstr("a surface is put into the plane and the outline of its base")));
    EXPECT_THROW(read_room("V 13 9 1 0\nS 7 9 13 11 12 1 0 0.8 hatch\n"), UserError) << "it reaches beyond";
}

TEST(RealVs3Files, LeaveHolesWhereNullSurfacesAre) {
    const Scene scene = read_room("C encl=1\nN 7 12 11 10 9 1 0 0.8 hole\n");
    EXPECT_DOUBLE_EQ(face_area(scene, 0), 11);
    EXPECT_EQ(scene.faces.size(), 6u);
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("null surface 7 leaves a hole in surface 1")));
}

TEST(RealVs3Files, MaskPartsOfTheirBases) {
    const Scene scene = read_room("C encl=1\nM 7 12 11 10 9 1 0 0.8 box\n");
    ASSERT_EQ(scene.masks.size(), 1u);
    const auto matrix = form_factors::find_matrix(scene, request_within_a_millionth());
    ASSERT_EQ(matrix.faces(), 7u);
    EXPECT_DOUBLE_EQ(matrix.areas[0], 12);
    EXPECT_EQ(matrix.exchange(0, 6).value, 1);
    EXPECT_EQ(matrix.exchange(1, 6).high, 0);
    EXPECT_EQ(matrix.rows[6].value, 1);
    EXPECT_NEAR(matrix.rows[0].value, 1, 1e-6);
    EXPECT_LT(matrix.rows[1].value, 0.99) << "it sees the back of the mask";
    EXPECT_FALSE(scene.closed);
    EXPECT_THROW(expect_no_masks(scene), UserError);
}

TEST(RealVs3Files, RefuseMasksThatOverlapAndConcaveParts) {
    const std::string mask = "M 7 12 11 10 9 1 0 0.8 box\n";
    EXPECT_THROW(read_room(mask + "M 8 12 11 10 9 1 0 0.8 box\n"), UserError);
    EXPECT_THROW(read_room("S 7 9 10 11 12 1 0 0.8 hatch\nM 8 12 11 10 9 1 0 0.8 box\n"), UserError);
    const Scene two = read_room(mask + "V 13 1 3 0\nV 14 2 3 0\nM 8 12 13 14 11 1 0 0.8 box\n");
    ASSERT_EQ(two.masks.size(), 2u) << "they touch";
    EXPECT_NE(two.masks[0].name, two.masks[1].name);
    EXPECT_THROW(read_room("V 13 1.4 1.6 0\nN 7 12 11 13 9 1 0 0.8 hole\n"), UserError);
}

// The room of format 3, placed by azimuth and tilt.
TEST(RealVs3Files, AreReadInFormat3a) {
    const Scene scene = read_real("a.vs3",
                                  "T a box\nC encl=1\nF 3a\n"
                                  "S 1 Q 0 0 0.9 floor\n 0 0 0 180 0\n 0 0 3 0 3 4 0 4\n"
                                  "S 2 Q 0 0 0.9 roof\n 0 0 2  180 180  0 0  0 -4  3 -4  3 0\n"
                                  "S 3 R 0 0 0.9 south\n 3 0 0 0 90 3 2\n"
                                  "S 4 r 0 0 0.9 east\n 3 4 0 270 90 4 2\n"
                                  "S 5 T 0 0 0.9 north\n 0 4 0 180 90 0 0 3 0 3 2\n"
                                  "S 6 T 0 5 0.9 north\n 0 4 0 180 90 0 0 3 2 0 2\n"
                                  "S 7 R 0 0 0.9 west\n 0 0 0 90 90 4 2\nEnd\n");
    EXPECT_THAT(scene.faces, ElementsAre("floor", "roof", "south", "east", "north", "west"));
    EXPECT_THAT(doubts_about(scene), IsEmpty());
    const Scene room = read_room("C encl=1\n");
    for (std::size_t face = 0; face < 6; ++face) {
        EXPECT_NEAR(face_area(scene, static_cast<int>(face)), face_area(room, static_cast<int>(face)), 1e-12);
        EXPECT_NEAR(factor_of(scene, 0, face), factor_of(room, 0, face), 1e-12);
    }
}

}  // namespace
}  // namespace ff::studies

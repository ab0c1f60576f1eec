// Statements of OBJ files, also those that are not of polygons, and surfaces that are wound differently where corners
// do not meet corners.
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string unit_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Scene read_statements(const std::string& text) {
    return make_scene(source_of_file("a.obj", text));
}

std::string refusal_of(const std::string& text) {
    return test::message_of<UserError>([&] { read_statements(text); });
}

TEST(ObjStatements, HaveNamesWithMarksOfComments) {
    EXPECT_THAT(
        read_statements(unit_square + "g Component #1\nf 1 2 3 4 # a comment\ng Component #2\nf 4 3 2 1\n").faces,
        ElementsAre("Component #1", "Component #2"));
    EXPECT_THAT(read_statements(unit_square + "g #1\nf 1 2 3 4\n").faces, ElementsAre("#1"));
}

TEST(ObjStatements, AreNamedWhereUnknown) {
    EXPECT_THAT(
        read_statements(unit_square + "f 1 2 3 4\nF 1 2 3\nface 1 2 3\nvt 0 0\ns off\n").remarks,
        ElementsAre("2 lines begin with what is no statement of OBJ files, and are passed over (the first, 'F', "
                    "in line 6)"));
    EXPECT_THAT(refusal_of("T title\nV 1 0 0 0\n"), HasSubstr("a.obj:1: no line of an OBJ file begins with 'T'"));
    EXPECT_THAT(refusal_of(unit_square + "f 1 2 3 4\nsurf 0 1 0 1 1 2 3 4\n"),
                HasSubstr("a.obj:6: 'surf' is a free-form"));
    EXPECT_THAT(refusal_of(unit_square + "f 1 2 3 4\ncall b.obj\n"), HasSubstr("a.obj:6: 'call' takes"));
}

TEST(ObjStatements, MayHavePolygonsOfTwoCorners) {
    const Scene scene = read_statements(unit_square + "f 1 2 3 4\nf 1 2\n");
    EXPECT_EQ(scene.surfaces.size(), 1);
    EXPECT_THAT(scene.remarks, ElementsAre("a polygon has no area and is left out (line 6)"));
    EXPECT_THAT(refusal_of(unit_square + "f\n"), HasSubstr("a.obj:5: a polygon needs three corners or more"));
}

TEST(ObjStatements, MayRepeatAPolygonWherePolygonsAreFaces) {
    const Scene scene = read_statements(unit_square + "# faces polygon\ng a\nf 1 2 3 4\nf 1 2 3 4\nf 4 3 2 1\n");
    EXPECT_THAT(scene.faces, ElementsAre("a.1", "a.3"));
    EXPECT_THAT(scene.remarks,
                ElementsAre("a polygon is a copy of another, not the other side of a sheet, and is left out (line 8)"));
}

TEST(ObjStatements, NameFacesThatAreLost) {
    EXPECT_THAT(read_statements(unit_square + "v 2 0 0\ng a\nf 1 2 3 4\ng b\nf 1 2 5\n").remarks,
                ElementsAre("'b' is left out, since no polygon with an area is left of it",
                            "a polygon has no area and is left out (line 9)"));
}

TEST(ObjStatements, MayHaveNamesWithBars) {
    const Scene scene = read_statements(unit_square + "g a|b\nf 1 2 3 4\ng a_b\nf 4 3 2 1\n");
    EXPECT_THAT(scene.faces, ElementsAre("a_b", "a_b.2"));
    EXPECT_THAT(scene.remarks, ElementsAre("'a|b' is written with _ for | here, which would break tables"));
}

TEST(ObjStatements, MayGiveAGroupSeveralMaterials) {
    const std::string two = unit_square + "g a\nusemtl x\nf 1 2 3 4\ng b\nusemtl x\nf 4 3 2 1\n";
    EXPECT_THAT(read_statements(two).remarks, IsEmpty());
    EXPECT_THAT(read_statements(two + "v 0 0 1\nusemtl y\nf 1 2 5\n").remarks,
                ElementsAre("its faces are its 2 groups or objects (with --faces material its 2 materials)"));
}

TEST(ObjStatements, MayRepeatAPolygonInAnotherGroup) {
    const std::string both = unit_square + "g a\nf 1 2 3 4\ng b\nf 1 2 3 4\n";
    const Scene scene = read_statements(both + "v 0 0 1\nf 1 2 5\n");
    EXPECT_THAT(scene.faces, ElementsAre("a", "b"));
    EXPECT_EQ(face_area(scene, 0), 1);
    EXPECT_EQ(face_area(scene, 1), 0.5);
    EXPECT_THAT(scene.remarks,
                ElementsAre("a polygon is of two faces and is counted for the first alone ('a' rather than 'b')",
                            "a polygon is a copy of another, not the other side of a sheet, and is left out (line 8)"));
    EXPECT_THAT(refusal_of(both), HasSubstr("a.obj:8: a surface of face 'b' is the same as a surface of face 'a'"));
}

TEST(ObjStatements, MayBeFoForPolygons) {
    EXPECT_EQ(read_statements(unit_square + "fo 1 2 3 4\n").surfaces.size(), 1);
}

TEST(ObjStatements, HaveNamesThatSpreadsheetsWouldCompute) {
    const Scene scene = read_statements(unit_square + "g @-Z\nf 1 2 3 4\ng =x\nf 4 3 2 1\n");
    EXPECT_THAT(scene.faces, ElementsAre("_@-Z", "_=x"));
    EXPECT_THAT(scene.remarks, ElementsAre("'@-Z', '=x' begin with _ here, since spreadsheets would take the names for "
                                           "formulas"));
}

TEST(ObjStatements, TellWhichFacesWereChosen) {
    EXPECT_THAT(
        read_statements(unit_square + "o a\nusemtl p\nf 1 2 3\nusemtl q\nf 1 3 4\no b\nusemtl r\nf 3 2 1\n").remarks,
        ElementsAre("its faces are its 2 groups or objects (with --faces material its 3 materials)"));
}

/// A strip of length 2 along x: a square, and beside it two halves, of which corners lie within its edge.
std::string strip(const std::string& gap, bool first_reversed, bool second_reversed) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv " + gap + " 0 0\nv 2 0 0\nv 2 0.5 0\nv " + gap +
                                " 0.5 0\nv 2 1 0\nv " + gap + " 1 0\ng strip\nf 1 2 3 4\n";
    return corners + (first_reversed ? "f 8 7 6 5\n" : "f 5 6 7 8\n") +
           (second_reversed ? "f 10 9 7 8\n" : "f 8 7 9 10\n");
}

TEST(WindingBesideEdges, IsThatOfTheMajority) {
    for (const char* const gap : {"1", "1.00000001", "1.000001"}) {
        const Scene scene = read_statements(strip(gap, true, false));
        for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.normal.z(), 1) << gap;
        EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("wound in the opposite direction"))) << gap;
        EXPECT_THAT(read_statements(strip(gap, false, false)).remarks, IsEmpty()) << gap;
    }
    EXPECT_THAT(examine_scene(read_statements(strip("1", true, true))).faults,
                ElementsAre(HasSubstr("face opposite ways")))
        << "half of the area";
}

TEST(WindingBesideEdges, IsLeftAloneWhereSurfacesLieOverEachOther) {
    const Scene scene = read_statements(unit_square + "g a\nf 1 2 3 4\nf 1 2 3\nf 1 3 4\n");
    for (const Surface& surface : scene.surfaces) EXPECT_EQ(surface.normal.z(), 1);
    EXPECT_THAT(examine_scene(scene).faults, ElementsAre(HasSubstr("lie over each other in one plane")));
}

// The top of a low step and the bottom of a high one lie in one plane and touch, and both are right.
TEST(WindingBesideEdges, IsLeftAloneOnBodiesThatTouch) {
    const auto box = [](int first, double x, double z) {
        std::string text;
        for (const double height : {z, z + 1}) {
            for (const auto& [i, k] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
                text += "v " + std::to_string(x + i) + " " + std::to_string(k * (x + 1)) + " " +
                        std::to_string(height) + "\n";
        }
        for (const auto& corners :
             {std::array{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}}) {
            text += "f";
            for (const int corner : corners) text += " " + std::to_string(first + corner);
            text += "\n";
        }
        return text;
    };
    EXPECT_THAT(read_statements("g steps\n" + box(0, 0, 0) + box(8, 1, 1)).remarks, IsEmpty());
}

}  // namespace
}  // namespace ff::studies

#include "studies/scene_files/scene_file.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace ff::studies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Scene read_text(std::string_view name, std::string_view text) {
    return make_scene(source_of_file(name, text));
}

std::string refusal_of_text(std::string_view name, std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(read_text(name, text)); });
}

constexpr std::string_view plates_toml = R"(
[[surface]]
face = "floor"
shape = "parallelogram"
corner = [0, 0, 0]
edge_u = [1, 0, 0]
edge_v = [0, 1, 0]

[[surface]]
face = "lid"
shape = "parallelogram"
corner = [0, 0, 1]
edge_u = [1, 0, 0]
edge_v = [0, 1, 0]
flip = true
)";

constexpr std::string_view plates_obj = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
g floor
f 1 2 3 4
g lid
f 5 8 7 6
)";

constexpr std::string_view plates_vs3 = R"(T two squares
C encl=0 list=2
F 3
! a comment
V 1 0. 0. 0.
V 2 1. 0. 0.
V 3 1. 1. 0.
V 4 0. 1. 0.
V 5 0. 0. 1.
V 6 1. 0. 1.
V 7 1. 1. 1.
V 8 0. 1. 1.
S 1 1 2 3 4 0 0 0.5 floor
S 2 7 6 5 8 0 0 0.5 lid
End of data
)";

// pi F = ln(4/3) / 2 ... of unit squares at distance 1: exact_form_factor of the cube.
TEST(SceneFiles, GiveTheSameSquaresInEveryFormat) {
    const double expected = *exact_form_factor(make_box(1, 1, 1), 0, 5);
    for (const auto& [name, text] :
         {std::pair("a.toml", plates_toml), std::pair("a.obj", plates_obj), std::pair("a.vs3", plates_vs3)}) {
        const Scene scene = read_text(name, text);
        EXPECT_EQ(scene.name, name);
        EXPECT_EQ(scene.faces, (std::vector<std::string>{"floor", "lid"}));
        EXPECT_FALSE(scene.closed);
        const auto exact = exact_form_factors(scene);
        ASSERT_TRUE(exact) << name;
        EXPECT_DOUBLE_EQ((*exact)(0, 1), expected);
        EXPECT_DOUBLE_EQ((*exact)(1, 0), expected);
    }
}

TEST(SceneFiles, KeyStreamsByTheirContentNotByTheirName) {
    const std::string canonical = read_text("a.obj", plates_obj).canonical;
    EXPECT_EQ(read_text("folder/b.obj", plates_obj).canonical, canonical);
    EXPECT_EQ(read_text("a.obj", "# a comment\n" + std::string(plates_obj)).canonical, canonical);
    EXPECT_NE(read_text("a.obj", std::string(plates_obj) + "v 2 2 2\ng more\nf 1 2 9\n").canonical, canonical);
    EXPECT_NE(read_text("a.obj", "# closed\n" + std::string(plates_obj)).canonical, canonical);
}

/// The plates, the first with this line.
std::string plates_with_line(std::string_view line) {
    std::string text(plates_toml);
    return text.insert(text.find("shape"), std::string(line) + "\n");
}

TEST(SceneFiles, DivideSurfacesByGrids) {
    const Scene plain = read_text("a.toml", plates_toml);
    EXPECT_FALSE(has_grids(plain));
    const Scene divided = read_text("a.toml", plates_with_line("grid = [3, 2]"));
    EXPECT_EQ(divided.surfaces[0].grid, (Grid{3, 2}));
    EXPECT_EQ(divided.surfaces[1].grid, undivided);
    EXPECT_TRUE(has_grids(divided));
    EXPECT_EQ(read_text("a.toml", plates_with_line("grid = [1024, 1]")).surfaces[0].grid, (Grid{1024, 1}));
}

// FNV-1a over 64-bit words, in Python: of the scene [0, of the surface, face, 0, 0, +-1, ...]; of a surface [its
// shape's index, its corners in order], as doubles. Stored studies rest on it.
TEST(SceneFiles, KeyStreamsByGridsAndKeepOldKeysWithoutThem) {
    const std::string plain = read_text("a.toml", plates_toml).canonical;
    EXPECT_EQ(plain, "scene e4194e8c8b83a782");
    EXPECT_EQ(read_text("a.toml", plates_with_line("grid = [1, 1]")).canonical, plain);
    const std::string divided = read_text("a.toml", plates_with_line("grid = [3, 2]")).canonical;
    EXPECT_NE(divided, plain);
    EXPECT_NE(read_text("a.toml", plates_with_line("grid = [2, 3]")).canonical, divided);
}

TEST(SceneFiles, RefuseInvalidGrids) {
    const auto message = [](std::string_view line) { return refusal_of_text("a.toml", plates_with_line(line)); };
    EXPECT_EQ(message("grid = [0, 1]"),
              "a.toml:4:8: grid = [ 0, 1 ] (a surface has 1 to 1024 parts each way). Write [4, 1].");
    for (const char* line : {"grid = [1, 0]", "grid = [1025, 1]", "grid = [1, 9223372036854775807]"})
        EXPECT_THAT(message(line), HasSubstr("(a surface has 1 to 1024 parts each way)")) << line;
    for (const char* line : {"grid = 3", "grid = [1, 2, 3]", "grid = [1]"})
        EXPECT_THAT(message(line), HasSubstr("(expected parts along s and along t)")) << line;
    for (const char* line :
         {"grid = [-1, 1]", "grid = [1.5, 1]", "grid = [1, \"2\"]", "grid = true", "grid = [nan, 1]"})
        EXPECT_THAT(message(line), HasSubstr("a.toml:4:8: grid = ")) << line;
    EXPECT_THAT(message("grid = []"), HasSubstr("a.toml:4:8: "));
    EXPECT_THAT(message("grid = [1, 2"), HasSubstr("a.toml:"));
}

TEST(SceneFiles, HaveEveryShapeInToml) {
    const Scene scene = read_text("round.toml", R"(
closed = false
surface = [
    { face = "triangle", shape = "triangle", a = [0, 0, 0], b = [1, 0, 0], c = [0, 1, 0] },
    { face = "ring", shape = "disc", centre = [0, 0, 1], normal = [0, 0, -2], radius = 2, inner_radius = 1 },
    { face = "tube", shape = "cylinder", base = [5, 0, 0], axis = [0, 0, 3], radius = 1, facing = "inward" },
    { face = "cone", shape = "cone", base = [9, 0, 0], axis = [0, 0, 2], base_radius = 1, top_radius = 0, facing = "outward" },
    { face = "ball", shape = "sphere", centre = [0, 9, 0], radius = 2, facing = "outward" },
    { face = "cap", shape = "sphere", centre = [0, 18, 0], radius = 2, axis = [0, 0, 1], low = 1, facing = "inward" },
    { shape = "parallelogram", corner = [0, 0, 5], edge_u = [1, 0, 0], edge_v = [0, 1, 0] },
]
)");
    ASSERT_EQ(scene.surfaces.size(), 7u);
    EXPECT_EQ(scene.faces.size(), 6u);
    EXPECT_EQ(scene.surfaces[6].face, no_face);
    EXPECT_EQ(scene.surfaces[1].normal, Eigen::Vector3d(0, 0, -1));
    // Areas: 1/2, 3 pi, 6 pi, pi sqrt(5), 16 pi, 2 pi r h = 4 pi.
    constexpr double pi = 3.14159265358979323846;
    EXPECT_DOUBLE_EQ(face_area(scene, 0), 0.5);
    EXPECT_DOUBLE_EQ(face_area(scene, 1), 3 * pi);
    EXPECT_DOUBLE_EQ(face_area(scene, 2), 6 * pi);
    EXPECT_DOUBLE_EQ(face_area(scene, 3), pi * std::sqrt(5.0));
    EXPECT_DOUBLE_EQ(face_area(scene, 4), 16 * pi);
    EXPECT_DOUBLE_EQ(face_area(scene, 5), 4 * pi);
}

TEST(SceneFiles, TakeGroupsAsFacesButNotOccluders) {
    const Scene scene = read_text("a.obj", std::string(plates_obj) + "g occluder\nf 1 2 6 5\ng floor\nf 1 2 7\n");
    EXPECT_EQ(scene.faces.size(), 2u);
    EXPECT_EQ(scene.surfaces[2].face, no_face);
    EXPECT_EQ(scene.surfaces[3].face, 0);
    const Scene combined = read_text("a.vs3", R"(F 3
C encl=1
V 1 0 0 0
V 2 1 0 0
V 3 1 1 0
V 4 0 0 1
S 1 1 2 3 0 0 0 0.9 both
S 2 1 4 2 0 0 1 0.9 part
O 3 1 3 4 0
)");
    EXPECT_TRUE(combined.closed);
    EXPECT_EQ(combined.faces, std::vector<std::string>{"both"});
    EXPECT_EQ(combined.surfaces[1].face, 0);
    EXPECT_EQ(combined.surfaces[2].face, no_face);
}

TEST(SceneFiles, DivideOtherPolygonsIntoTriangles) {
    const Scene scene = read_text("a.obj", "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 0 1 0\ng a\nf 1 2 3 4\n");
    EXPECT_EQ(scene.surfaces.size(), 2u);
    EXPECT_DOUBLE_EQ(face_area(scene, 0), 1.5);
}

struct Broken {
    const char* name;
    std::string text;
    const char* place;
    const char* problem;
};

TEST(SceneFiles, AreRefusedByFileAndLine) {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 1 1\nv 0.2 0.3 0\n";
    const std::string vs3 = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 1 1 0\n";
    const std::string disc = "[[surface]]\nface = 'a'\nshape = 'disc'\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\n";
    const std::string shape = "shape = 'disc'\nradius = 1\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\n";
    const std::vector<Broken> all{
        {"a.obj", obj + "g a\nf 1 2 2\n", "a.obj: ", "no face"},
        {"a.obj", obj + "g a\nf 1 3 6 2\n", "a.obj:8: ", "cross or touch each other"},
        {"a.obj", obj + "g a\nf 1 3 2 4\n", "a.obj:8: ", "cancel out"},
        {"a.obj", obj + "g a\nf 1 2 9\n", "a.obj:8: ", "vertex 9"},
        {"a.obj", obj + "v 1 0 1\ng a\nf 1 2 -9\n", "a.obj:9: ", "corner 3 is vertex -9 (the file has 7)"},
        {"a.obj", obj + "v nan 0 0\n", "a.obj:7: ", "three finite coordinates"},
        {"a.obj", obj + "v 1 inf 0\n", "a.obj:7: ", "three finite coordinates"},
        {"a.obj", obj + "v 1 2\n", "a.obj:7: ", "three finite coordinates"},
        {"a.obj", obj + "f\n", "a.obj:7: ", "three corners"},
        {"a.obj", obj + "g a\nf 1 2 3\ng b\nf 3 1 2\n", "a.obj:10: ", "the same as a surface of face 'a' of line 8"},
        {"a.obj", obj, "a.obj: ", "no face"},
        {"a.obj", obj + "g b\nf 1 2 4\ng a\u202eb\nf 1 2 3\n", "a.obj:10: ", "would break tables"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 0 0 0.9 a\x01\n", "a.vs3:5: ", "would break tables"},
        {"a.toml", "[[surface]]\nface = \"a\\nb\"\n" + shape, "a.toml:1:", "would break tables"},
        {"a.obj", obj + "v 1e200 0 0\ng a\nf 1 2 7\n", "a.obj:9: ", "reaches beyond"},
        {"a.vs3", vs3 + "V 4 0,5 1 0,5\n", "a.vs3:5: ", "three coordinates, and '0' follows"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 0 0 0,9 floor\n",
         "a.vs3:5: ", "field 9 is '0,9' (commas separate fields). Write 0.9"},
        {"a.vs3", vs3 + "S 1 1 2 7 0\n", "a.vs3:5: ", "vertex 7 is not defined"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 0 0 floor\n", "a.vs3:5: ", "field 9 is 'floor' (expected an emissivity"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 0 0 1.1 floor\n", "a.vs3:5: ", "field 9 is '1.1' (expected an emissivity"},
        {"a.vs3", vs3 + "V 3 0 0 0\n", "a.vs3:5: ", "twice"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 4 0 0.9 a\n", "a.vs3:5: ", "lies on surface 4, which does not come before"},
        {"a.vs3", vs3 + "N 1 1 2 3 0 0 0 0.9 a\n", "a.vs3:5: ", "has no base"},
        {"a.vs3", "C encl=yes\n", "a.vs3:1: ", "has no number"},
        {"a.vs3", "F 3a\nS 1 X 0 0 0.9 a\n", "a.vs3:2: ", "expected a shape"},
        {"a.vs3", "F 3a\nS 1 R 0 0 0.9 a\n 0 0 0 b\n", "a.vs3:3: ", "number 4 of 7"},
        {"a.vs3", "F 3a\nS 1 R 0 0 0.9 a\n 0 0 0 0\n", "a.vs3:2: ", "it has 4 of 7"},
        {"a.vs3", vs3 + "S 1 1 2 3 0 0 4 0.9 a\n", "a.vs3:5: ", "combined"},
        {"a.vs3", "F 2\n", "a.vs3:1: ", "three-dimensional"},
        {"a.vs3", "Q 2\n", "a.vs3:1: ", "begins with 'Q'"},
        {"a.toml", disc + "radius = -1\n", "a.toml:6:", "not negative"},
        {"a.toml", disc + "radius = 1\ninner_radius = 1\n", "a.toml:7:", "nothing is left"},
        {"a.toml", disc + "radius = nan\n", "a.toml:6:", "finite"},
        {"a.toml", disc + "radius = 0\n", "a.toml:6:", "not positive"},
        {"a.toml", disc + "radius = 1\nwidth = 2\n", "a.toml:7:", "width"},
        {"a.toml", "[[surface]]\nshape = 'ball'\n", "a.toml:2:", "ball"},
        {"a.toml", "[[surface]]\nface = 'a'\n", "a.toml:1:", "shape"},
        {"a.toml", "closed = 1\n", "a.toml:1:", "true or false"},
        {"a.toml", "", "a.toml: ", "no face"},
    };
    for (const Broken& broken : all) {
        const std::string message = refusal_of_text(broken.name, broken.text);
        EXPECT_THAT(message, testing::StartsWith(broken.place)) << broken.text;
        EXPECT_THAT(message, HasSubstr(broken.problem)) << broken.text;
    }
}

TEST(SceneSource, IsReadAsItIsWritten) {
    for (const char* written :
         {"cube", "cube mirrors:6", "a.obj mirrors:left+right", "a.obj mirrors:6\nv 0 0 0\n", "a.obj\n"})
        EXPECT_EQ(scene_source(written).written(), written);
    const SceneSource source = scene_source("a.obj mirrors:left+right\nf 1 2 3");
    EXPECT_EQ(source.name, "a.obj");
    EXPECT_THAT(source.mirrors, testing::ElementsAre("left", "right"));
    EXPECT_EQ(source.text, "f 1 2 3");
    EXPECT_EQ(source.title(), "a.obj mirrors:left+right");
}

TEST(SceneFiles, CannotBeUsedWithoutTheirText) {
    EXPECT_TRUE(scene_source("a.obj").is_file());
    EXPECT_FALSE(scene_source("box:2x1x0.5").is_file());
    EXPECT_FALSE(scene_source("a.obj").text);
    EXPECT_THROW(static_cast<void>(make_scene("a.obj")), UserError);
    EXPECT_EQ(make_scene("cube").faces.size(), 6u);
}

/// A closed box by its normals, one of which can be turned.
std::string box_obj(bool turned) {
    return "# closed\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
           "g floor\nf 1 2 3 4\ng lid\nf 5 8 7 6\ng south\nf 1 5 6 2\ng east\nf 2 6 7 3\ng north\nf 3 7 8 4\ng west\n" +
           std::string(turned ? "f 4 1 5 8\n" : "f 4 8 5 1\n");
}

TEST(Doubts, AreEmptyForASoundScene) {
    EXPECT_THAT(doubts_about(read_text("a.obj", box_obj(false))), IsEmpty());
    EXPECT_THAT(doubts_about(make_box(2, 1, 3)), IsEmpty());
}

TEST(Doubts, NameTheFaceWhoseNormalsAreWrong) {
    const auto doubts = doubts_about(read_text("a.obj", box_obj(true)));
    ASSERT_EQ(doubts.size(), 1u);
    EXPECT_THAT(doubts[0], HasSubstr("scene 'a.obj': face 'west' seems to face the wrong way"));
}

}  // namespace
}  // namespace ff::studies

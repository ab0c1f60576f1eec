// The messages about scenes that are not what the user meant: each kind has its own text.

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The walls of a unit room, corners in order as seen from inside.
constexpr std::array walls_from_inside{"1 2 3 4", "5 8 7 6", "1 5 6 2", "2 6 7 3", "3 7 8 4", "4 8 5 1"};
constexpr std::array walls_from_outside{"4 3 2 1", "6 7 8 5", "2 6 5 1", "3 7 6 2", "4 8 7 3", "1 5 8 4"};
constexpr std::array wall_names{"floor", "lid", "south", "east", "north", "west"};

/// @param turned  walls that face outwards
std::string room_obj(bool closed, const std::vector<std::size_t>& turned, const std::string& more = "") {
    std::string text = closed ? "# closed\n" : "";
    text += "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" + more;
    for (std::size_t wall = 0; wall < walls_from_inside.size(); ++wall) {
        const bool is_turned = std::find(turned.begin(), turned.end(), wall) != turned.end();
        text += fmt::format("g {}\nf {}\n", wall_names.at(wall),
                            is_turned ? walls_from_outside.at(wall) : walls_from_inside.at(wall));
    }
    return text;
}

Scene read_obj(const std::string& text) {
    return make_scene(source_of_file("a.obj", text));
}

const std::vector<std::size_t> all_walls{0, 1, 2, 3, 4, 5};

TEST(SceneDoubts, AreEmptyForASoundRoom) {
    for (const bool closed : {false, true}) {
        const SceneDoubts doubts = examine_scene(read_obj(room_obj(closed, {})));
        EXPECT_THAT(doubts.faults, IsEmpty());
        EXPECT_THAT(doubts.notes, IsEmpty());
    }
}

TEST(SceneDoubts, NameTheOneWallThatFacesTheWrongWay) {
    for (std::size_t wall = 0; wall < walls_from_inside.size(); ++wall) {
        const SceneDoubts doubts = examine_scene(read_obj(room_obj(true, {wall})));
        EXPECT_THAT(
            doubts.faults,
            ElementsAre(AllOf(HasSubstr(fmt::format("face '{}' seems to face the wrong way", wall_names.at(wall))),
                              HasSubstr("Turn it round: reverse the order of the corners of each polygon."))));
    }
}

TEST(SceneDoubts, NameTwoWallsThatFaceTheWrongWay) {
    const SceneDoubts doubts = examine_scene(read_obj(room_obj(true, {1, 4})));
    EXPECT_THAT(doubts.faults, ElementsAre(AllOf(HasSubstr("faces 'lid', 'north' seem to face the wrong way"),
                                                 HasSubstr("Turn them round"))));
}

// It may be the outside of a body, where the scene is not said to be closed.
TEST(SceneDoubts, AreFaultsWhereEveryFaceOfAClosedSceneFacesOutwards) {
    EXPECT_THAT(examine_scene(read_obj(room_obj(true, all_walls))).faults,
                ElementsAre(HasSubstr("faces seem to face outwards")));
    const SceneDoubts doubts = examine_scene(read_obj(room_obj(false, all_walls)));
    EXPECT_THAT(doubts.faults, ElementsAre());
    EXPECT_THAT(doubts.notes, ElementsAre(HasSubstr("faces seem to face outwards")));
}

TEST(SceneDoubts, AreFaultsWhereNoFaceSeesAnother) {
    EXPECT_THAT(examine_scene(read_obj(room_obj(false, {0, 1, 2, 4, 5}))).faults,
                ElementsAre(HasSubstr("face outwards")));
}

TEST(SceneDoubts, ReportOneFaultForARoomWithAHole) {
    std::string text = room_obj(true, {});
    text = text.substr(0, text.find("g west"));
    EXPECT_THAT(examine_scene(read_obj(text)).faults, ElementsAre(HasSubstr("rays meet nothing")));
}

std::string square(const std::string& face, const std::string& corner, double edge, bool flip = false) {
    return fmt::format(
        "[[surface]]\n{}shape = \"parallelogram\"\ncorner = {}\nedge_u = [{}, 0, 0]\nedge_v = [0, {}, 0]\n"
        "flip = {}\n",
        face.empty() ? "" : fmt::format("face = \"{}\"\n", face), corner, edge, edge, flip);
}

SceneDoubts doubts_of(const std::string& toml) {
    return examine_scene(make_scene(source_of_file("a.toml", toml)));
}

const std::string two_plates = square("a", "[0, 0, 0]", 1) + square("b", "[0, 0, 1]", 1, true);

TEST(SceneDoubts, NameFacesThatLieOverEachOther) {
    EXPECT_THAT(doubts_of(two_plates).faults, IsEmpty());
    EXPECT_THAT(doubts_of(two_plates + square("pic", "[0.3, 0.3, 0]", 0.4)).faults,
                ElementsAre(AllOf(HasSubstr("'a' and 'pic'"), HasSubstr("100 % of 'pic'"))));
    EXPECT_THAT(doubts_of(two_plates + square("pic", "[0.3, 0.3, 1e-7]", 0.4)).faults, IsEmpty());
    EXPECT_THAT(doubts_of(two_plates + square("a", "[0.5, 0, 0]", 1)).faults, ElementsAre(HasSubstr("counted twice")));
}

TEST(SceneDoubts, NameAnOccluderThatLiesOnAFace) {
    EXPECT_THAT(doubts_of(two_plates + square("", "[0.3, 0.3, 0]", 0.4)).faults,
                ElementsAre(AllOf(HasSubstr("an occluder lies on face 'a'"), HasSubstr("16 % of it"))));
}

TEST(SceneDoubts, NameFacesThatAreNearlyInOnePlane) {
    const SceneDoubts doubts = examine_scene(read_obj(
        room_obj(false, {}, "v 0.2 0.2 1e-7\nv 0.4 0.2 1e-7\nv 0.4 0.4 1e-7\nv 0.2 0.4 1e-7\ng mat\nf 9 10 11 12\n")));
    EXPECT_THAT(doubts.faults, IsEmpty());
    EXPECT_THAT(doubts.notes, ElementsAre(HasSubstr("less than a millionth of their size apart")));
}

/// A picture on a wall along u and v, with so many decimals: their rounding puts it partly in front and partly behind.
Scene wall_with_picture(const Eigen::Vector3d& u, const Eigen::Vector3d& v, int decimals) {
    std::string text;
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.3, 0.4}, {0.6, 0.4}, {0.6, 0.7}, {0.3, 0.7}}) {
        const Eigen::Vector3d place = (x * u + y * v) / 2.71;
        text += fmt::format("v {0:.{3}f} {1:.{3}f} {2:.{3}f}\n", place.x(), place.y(), place.z(), decimals);
    }
    return read_obj(text + "g wall\nf 1 2 3\nf 1 3 4\ng picture\nf 5 6 7\nf 5 7 8\n");
}

TEST(SceneDoubts, TrustCoordinatesOnlyToTheirDigits) {
    const Eigen::Vector3d u(0.8, 0.36, 0.48);
    const Eigen::Vector3d v(-0.6, 0.48, 0.64);
    const Scene scene = wall_with_picture(u, v, 6);
    EXPECT_DOUBLE_EQ(scene.coordinate_rounding, 5e-7);
    EXPECT_THAT(examine_scene(scene).faults, ElementsAre(HasSubstr("lie over each other in one plane")));
    EXPECT_THAT(examine_scene(wall_with_picture(u, v, 3)).faults,
                ElementsAre(HasSubstr("nearer than coordinates tell that may be rounded to 0.001")));
    // Along the axes all of a plane is rounded to the same place.
    const Scene upright = wall_with_picture({1, 0, 0}, {0, 1, 0}, 3);
    EXPECT_DOUBLE_EQ(upright.coordinate_step, 1e-3);
    EXPECT_THAT(examine_scene(upright).faults, ElementsAre(HasSubstr("lie over each other in one plane")));
}

/// Two rooms' floors beside a third, at the middle of its edge; `over` is how far the third reaches over them.
Scene floors(double angle, double over, int decimals) {
    std::string text;
    const auto add = [&](double x, double y) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        text += fmt::format("v {0:.{2}f} {1:.{2}f} 0\n", c * x - s * y, s * x + c * y, decimals);
    };
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {6.013 + over, 0.0}, {6.013 + over, 8.0}, {0.0, 8.0}}) add(x, y);
    for (const double y : {0.0, 3.217, 8.0}) {
        add(6.013, y);
        add(12.0, y);
    }
    return read_obj(text + "g hall\nf 1 2 3 4\ng office\nf 5 6 8 7\ng store\nf 7 8 10 9\n");
}

TEST(SceneDoubts, NoteOverlapsThatRoundedCornersExplain) {
    std::size_t rounded = 0;
    for (int k = 1; k <= 12; ++k) {
        const SceneDoubts doubts = examine_scene(floors(0.1273 * k, 0, 3));
        EXPECT_THAT(doubts.faults, IsEmpty()) << k;
        for (const std::string& note : doubts.notes)
            rounded += note.find("no more than rounded corners explain") != std::string::npos;
        EXPECT_THAT(examine_scene(floors(0.1273 * k, 0.02, 3)).faults, SizeIs(2)) << k;
    }
    EXPECT_GE(rounded, 6u) << "the others have a gap";
    EXPECT_THAT(examine_scene(floors(0, 0.001, 3)).faults, SizeIs(2)) << "along axes rounding explains nothing";
}

/// A floor and a box on it without a bottom, turned about x, with coordinates that `rounded` gives.
template <class Round>
Scene floor_with_box(double angle, const Round& rounded) {
    std::string text;
    const auto add = [&](double x, double y, double z) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        text += fmt::format("v {} {} {}\n", rounded(x), rounded(c * y - s * z), rounded(s * y + c * z));
    };
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}}) add(x, y, 0);
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : {std::pair(1.5, 1.0), {2.5, 1.0}, {2.5, 2.0}, {1.5, 2.0}}) add(x, y, z);
    }
    return read_obj(text +
                    "g floor\nf 1 2 3 4\ng box\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\nf 9 10 11 12\n");
}

TEST(SceneDoubts, NameAFloorThatABodyMayStandOn) {
    const auto in_full = [](double x) { return fmt::format("{:.17g}", x); };
    EXPECT_THAT(examine_scene(floor_with_box(0.5, in_full)).faults, IsEmpty());
    EXPECT_THAT(examine_scene(floor_with_box(0.5, in_full)).notes,
                testing::Contains(HasSubstr("of face 'floor' is covered")));
    const auto may_stand = ElementsAre(HasSubstr("a body may stand on face 'floor'"));
    EXPECT_THAT(examine_scene(floor_with_box(0.5, [](double x) { return fmt::format("{:.3f}", x); })).faults,
                may_stand);
    EXPECT_THAT(examine_scene(floor_with_box(0.5, [](double x) { return fmt::format("{:.5g}", x); })).faults,
                may_stand);
    EXPECT_THAT(examine_scene(floor_with_box(0.5, [](double x) { return std::round(64 * x) / 64; })).faults, may_stand);
    EXPECT_THAT(examine_scene(floor_with_box(0, [](double x) { return fmt::format("{:.3f}", x); })).faults, IsEmpty());
}

TEST(SceneDoubts, CountWhatManyBodiesCover) {
    std::string text = "v 0 0 0\nv 9 0 0\nv 9 1 0\nv 0 1 0\ng floor\nf 1 2 3 4\n";
    for (int k = 0; k < 4; ++k) {
        for (const int z : {0, 1 + k}) {
            for (const auto& [x, y] : {std::pair(0.1, 0.1), {1.1, 0.1}, {1.1, 0.6}, {0.1, 0.6}})
                text += fmt::format("v {} {} {}\n", x + 2 * k, y, z);
        }
        text += fmt::format(
            "g leg{}\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\nf -4 -3 -2 -1\nf -5 -6 -7 -8\n", k);
    }
    EXPECT_THAT(examine_scene(read_obj(text)).notes,
                ElementsAre(AllOf(HasSubstr("5 faces are covered"),
                                  HasSubstr("22.2 % of 'floor', 12.5 % of 'leg0', 7.14 % of 'leg1' and 2 more"))));
}

// A sheet of 2 mm in millimetres, turned: what its sides hide of each other is no question.
TEST(SceneDoubts, AllowAThinSheet) {
    std::string text;
    for (const double z : {0.0, 0.002}) {
        for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.234, 0.0}, {1.234, 0.987}, {0.0, 0.987}})
            text += fmt::format("v {:.3f} {:.3f} {:.3f}\n", x, 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z);
    }
    const Scene sheet = read_obj(text + "g sheet\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    EXPECT_DOUBLE_EQ(sheet.coordinate_step, 1e-3);
    EXPECT_THAT(examine_scene(sheet).faults, IsEmpty());
}

TEST(SceneDoubts, NoteARoundBodyOnAFace) {
    const std::string cylinder =
        "[[surface]]\nface = 'c'\nshape = 'cylinder'\nbase = [0.5, 0.5, 0]\naxis = [0, 0, 0.3]\nradius = 0.2\n"
        "facing = 'outward'\n";
    const auto stands = testing::Contains(HasSubstr("face 'c' stands on face 'a'"));
    EXPECT_THAT(doubts_of(two_plates + cylinder).notes, stands);
    const std::string raised = std::string(cylinder).replace(cylinder.find("0.5, 0]"), 7, "0.5, 0.1]");
    EXPECT_THAT(doubts_of(two_plates + raised).notes, testing::Not(stands));
}

TEST(SceneDoubts, AreFaultsWhereCoordinatesAreTooCoarse) {
    const Scene scene = read_obj(
        "v 41234.5 1.23457 2.34568\nv 41234.7 1.23457 2.34568\nv 41234.7 1.43457 2.34568\n"
        "v 41234.5 1.43457 3.34568\nv 41234.7 1.23457 3.34568\nv 41234.7 1.43457 3.34568\n"
        "g a\nf 1 2 3\ng b\nf 6 5 4\n");
    EXPECT_THAT(examine_scene(scene).faults, testing::Contains(HasSubstr("coordinates seem to be rounded to 0.1")));
}

TEST(SceneDoubts, TreatSurfacesBackToBackAsAThinWall) {
    const SceneDoubts doubts =
        doubts_of(two_plates + square("under", "[0, 0, 0]", 1.001, true) + square("c", "[0, 0, -1]", 1));
    EXPECT_THAT(doubts.faults, IsEmpty());
    EXPECT_THAT(doubts.notes, ElementsAre(HasSubstr("'a' and 'under' lie in one plane back to back")));
}

TEST(FormFactors, AreNotTrustedWhereRowsCannotAddUpToOne) {
    // No ray is needed here, so that none is lost.
    std::string text = room_obj(true, {});
    text = text.substr(0, text.find("g west"));
    const Scene scene = read_obj(text);
    const form_factors::Matrix matrix = form_factors::find_matrix(scene, {});
    EXPECT_FALSE(form_factors::is_trusted(scene, matrix, 1e-5));
    const Scene sound = read_obj(room_obj(true, {}));
    EXPECT_TRUE(form_factors::is_trusted(sound, form_factors::find_matrix(sound, {}), 1e-5));
    form_factors::Matrix faulty = form_factors::find_matrix(sound, {});
    faulty.faults = {"something"};
    EXPECT_FALSE(form_factors::is_trusted(sound, faulty, 1e-5));
}

TEST(FormFactors, HoldEveryPrintedSumInItsInterval) {
    for (const double turn : {0.0, 1.0}) {
        // Surfaces over each other: rows add up to more than 1.
        Scene scene = read_obj(room_obj(true, {}));
        Surface twice = scene.surfaces[1];
        parallelogram(twice).edge_u *= 0.5 + turn / 4;
        scene.faces.emplace_back("twice");
        twice.face = 6;
        scene.surfaces.push_back(twice);
        const form_factors::Matrix matrix = form_factors::find_matrix(scene, {});
        EXPECT_FALSE(form_factors::is_trusted(scene, matrix, 1e-5));
        for (const form_factors::RowSum& row : matrix.rows) {
            EXPECT_LE(row.low, row.value);
            EXPECT_GE(row.high, row.value);
        }
        EXPECT_GT(matrix.rows[0].low, 1.01);
    }
}

}  // namespace
}  // namespace ff::studies

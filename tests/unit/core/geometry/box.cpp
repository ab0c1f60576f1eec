#include "core/geometry/box.hpp"
#include "core/configurations/built_in_scene.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace ff {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The message that a user reads when a call fails.
template <class Call>
std::string message_of(const Call& call) {
    try {
        call();
    } catch (const UserError& error) {
        return error.what();
    }
    return "no error";
}

std::string box_message(double a, double b, double c) {
    return message_of([&] { make_box(a, b, c); });
}

std::string scene_message(const std::string& name) {
    return message_of([&] { built_in_scene(name); });
}

Eigen::Vector3d centre(const Surface& surface) {
    return parallelogram(surface).corner + (parallelogram(surface).edge_u + parallelogram(surface).edge_v) / 2;
}

TEST(MakeBox, NumbersTheFacesAsThePaperDoes) {
    const Scene box = make_box(2, 3, 5);
    EXPECT_THAT(box.faces, ElementsAre("1", "2", "3", "4", "5", "6"));
    ASSERT_EQ(box.surfaces.size(), 6u);
    const std::array<Eigen::Vector3d, 6> centres{{{1, 1.5, 0},    // 1: floor, opposite 6
                                                  {1, 3, 2.5},    // 2: back, opposite 3
                                                  {1, 0, 2.5},    // 3: front
                                                  {0, 1.5, 2.5},  // 4: left, opposite 5
                                                  {2, 1.5, 2.5},  // 5: right
                                                  {1, 1.5, 5}}};  // 6: ceiling
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(centre(box.surfaces[i]), centres[i]) << "face " << box.faces[i];
        EXPECT_EQ(box.surfaces[i].face, static_cast<int>(i));
    }
}

TEST(MakeBox, HasUnitNormalsThatPointInwardAndEdgesAlongThePositiveAxes) {
    const Scene box = make_box(2, 3, 5);
    for (const Surface& surface : box.surfaces) {
        const Eigen::Vector3d inward = Eigen::Vector3d(1, 1.5, 2.5) - centre(surface);
        EXPECT_EQ(surface.normal, inward.normalized());
        EXPECT_EQ(surface.normal.cross(parallelogram(surface).edge_u.cross(parallelogram(surface).edge_v)).norm(), 0);
        EXPECT_GE(parallelogram(surface).edge_u.minCoeff(), 0);
        EXPECT_GE(parallelogram(surface).edge_v.minCoeff(), 0);
    }
}

TEST(MakeBox, IsClosedAndEmpty) {
    const Scene box = make_box(2, 3, 5);
    EXPECT_TRUE(box.closed);
    EXPECT_EQ(box.empty_box.value(), Eigen::Vector3d(2, 3, 5));
}

TEST(MakeBox, RefusesInvalidEdgeLengths) {
    EXPECT_THAT(box_message(0, 1, 1), AllOf(HasSubstr("edge a = 0"), HasSubstr("positive"), HasSubstr("Try")));
    EXPECT_THAT(box_message(1, -2.5, 1), HasSubstr("edge b = -2.5"));
    EXPECT_THAT(box_message(1, 1, std::nan("")), HasSubstr("edge c = nan"));
    EXPECT_THAT(box_message(std::numeric_limits<double>::infinity(), 1, 1), HasSubstr("edge a = inf"));
    EXPECT_THAT(box_message(1, 1e200, 1), AllOf(HasSubstr("edge b = 1e+200"), HasSubstr("unit")));
    EXPECT_THAT(box_message(1, 1, 1e-200), HasSubstr("edge c = 1e-200"));
}

TEST(BuiltInScene, KnowsTheCubeOfThePaper) {
    const Scene cube = built_in_scene("cube");
    EXPECT_EQ(cube.name, "cube");
    EXPECT_EQ(cube.empty_box.value(), Eigen::Vector3d(6, 6, 6));
}

TEST(BuiltInScene, NamesTheSameGeometryTheSameWhateverTheUserCallsIt) {
    EXPECT_EQ(built_in_scene("cube").canonical, "box a=6 b=6 c=6");
    EXPECT_EQ(built_in_scene("box:6x6x6").canonical, "box a=6 b=6 c=6");
    EXPECT_EQ(built_in_scene("box:6.0x60e-1x6").canonical, "box a=6 b=6 c=6");
    EXPECT_EQ(built_in_scene("box:6.0x60e-1x6").name, "box:6.0x60e-1x6");
    EXPECT_EQ(built_in_scene("box:2x1x0.1").canonical, "box a=2 b=1 c=0.1");
    EXPECT_NE(built_in_scene("box:1x2x3").canonical, built_in_scene("box:1x3x2").canonical);
}

TEST(BuiltInScene, DistinguishesNeighbouringNumbers) {
    EXPECT_EQ(make_box(1, 1, 0.1).canonical, "box a=1 b=1 c=0.1");
    EXPECT_NE(make_box(1, 1, std::nextafter(0.1, 1)).canonical, make_box(1, 1, 0.1).canonical);
}

TEST(BuiltInScene, RefusesBoxesUnlessOfThreeNumbers) {
    for (const char* name : {"box:", "box:1", "box:1x2", "box:1x2x", "box:1x2x3x4", "box:1x2x3 ", "box:axbxc",
                             "box: 1x2x3", "box:1,2,3", "box:1xx2x3"}) {
        EXPECT_THAT(scene_message(name), AllOf(HasSubstr(name), HasSubstr("box:AxBxC"), HasSubstr("Try"))) << name;
    }
    EXPECT_THAT(scene_message("box:1x-2x3"), HasSubstr("edge b = -2"));
    EXPECT_THAT(scene_message("box:1x2xnan"), HasSubstr("edge c = nan"));
}

TEST(BuiltInScene, SuggestsTheNearestKnownName) {
    EXPECT_THAT(scene_message("cubes"), AllOf(HasSubstr("scene cubes"), HasSubstr("Did you mean cube?")));
    EXPECT_THAT(scene_message("Cube"), HasSubstr("Did you mean cube?"));
    EXPECT_THAT(scene_message("bx:1x2x3"), HasSubstr("Did you mean box:1x2x3?"));
    EXPECT_THAT(scene_message("cornell"), AllOf(HasSubstr("unknown"), HasSubstr("cube"), HasSubstr("box:2x1x0.5")));
    EXPECT_THAT(scene_message(""), HasSubstr("Try cube"));
}

}  // namespace
}  // namespace ff

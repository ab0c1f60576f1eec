#include "core/visibility/facing.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

using test::scene_of;

TEST(Facing, NeedsSomeOfEachSurfaceInFrontOfTheOther) {
    const Surface floor = test::rectangle("0:1 0:1 0:0 +z");
    EXPECT_TRUE(face_each_other(floor, test::rectangle("0:1 0:1 1:1 -z")));
    EXPECT_FALSE(face_each_other(floor, test::rectangle("0:1 0:1 1:1 +z"))) << "turned away";
    EXPECT_FALSE(face_each_other(floor, test::rectangle("0:1 0:1 0:0 -z"))) << "in one plane";
    EXPECT_FALSE(face_each_other(floor, test::rectangle("0:1 0:0 -1:0 +y"))) << "below the horizon";
    EXPECT_TRUE(face_each_other(floor, test::rectangle("0:1 0:0 -1:1 +y"))) << "partly above the horizon";
}

TEST(Facing, FindsFacesCutByThePlaneOfTheOther) {
    const auto floor_and = [](const char* other) {
        Scene scene = scene_of({test::rectangle("0:1 0:1 0:0 +z"), test::rectangle(other)});
        return are_partly_behind(scene, 0, 1) && are_partly_behind(scene, 1, 0);
    };
    EXPECT_FALSE(floor_and("0:1 0:1 1:1 -z"));
    EXPECT_FALSE(floor_and("0:1 0:0 0:1 +y")) << "a wall that stands on the floor";
    EXPECT_TRUE(floor_and("0:1 0:0 -1:1 +y")) << "a wall that reaches below the floor";
    EXPECT_TRUE(floor_and("0:1 0.5:0.5 0:1 +y")) << "a wall with floor behind it";
}

TEST(Convexity, HoldsInsideEveryBox) {
    EXPECT_TRUE(is_convex(make_box(6, 6, 6)));
    EXPECT_TRUE(is_convex(make_box(1e-3, 7, 2)));
    EXPECT_TRUE(is_convex(make_box(1.0 / 3, 0.1, 1e6)));
}

TEST(Convexity, FailsWhereOcclusionIsPossible) {
    Scene with_screen = make_box(6, 6, 6);
    with_screen.surfaces.push_back(test::rectangle("2:4 2:4 3:3 +z"));
    with_screen.surfaces.back().face = 6;
    with_screen.faces.emplace_back("screen");
    EXPECT_FALSE(is_convex(with_screen));
}

TEST(Convexity, DoesNotRequireAClosedScene) {
    EXPECT_TRUE(is_convex(scene_of({test::rectangle("0:1 0:1 0:0 +z"), test::rectangle("0:1 0:1 1:1 -z")})));
    EXPECT_FALSE(is_convex(scene_of({test::rectangle("0:1 0:1 0:0 +z"), test::rectangle("0:1 0:1 1:1 +z")})));
    EXPECT_FALSE(is_convex(scene_of({test::rectangle("0:1 0:1 0:0 +z"), test::rectangle("0:1 0:0 -1:1 +y")})));
}

}  // namespace
}  // namespace ff

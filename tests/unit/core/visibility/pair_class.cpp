#include "core/visibility/pair_class.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numbers>
#include <vector>

namespace ff {
namespace {

using test::rectangle;
using test::scene_of;

PairClass class_of(const Surface& a, const Surface& b) {
    const Scene scene = scene_of({a, b});
    EXPECT_EQ(pair_class(scene, 0, 1), pair_class(scene, 1, 0));
    return pair_class(scene, 0, 1);
}

const Surface floor_piece = rectangle("0:1 0:1 0:0 +z");

TEST(PairClass, IsParallelForOppositeFacesOfABoxAndAdjacentOtherwise) {
    const Scene box = make_box(1, 20, 0.3);
    const std::vector<int> opposite{5, 2, 1, 4, 3, 0};
    for (int from = 0; from < 6; ++from) {
        for (int to = 0; to < 6; ++to) {
            const auto expected = from == to                                       ? PairClass::self
                                  : opposite[static_cast<std::size_t>(from)] == to ? PairClass::parallel
                                                                                   : PairClass::adjacent;
            EXPECT_EQ(pair_class(box, from, to), expected) << from << " to " << to;
        }
    }
}

TEST(PairClass, IsParallelAtAnyOffsetEvenInOnePlane) {
    EXPECT_EQ(class_of(floor_piece, rectangle("7:8 0:1 3:3 -z")), PairClass::parallel);
    EXPECT_EQ(class_of(floor_piece, rectangle("1:2 0:1 0:0 +z")), PairClass::parallel);
}

TEST(PairClass, IsAdjacentWhereAPartOfAnEdgeIsShared) {
    EXPECT_EQ(class_of(floor_piece, rectangle("0.75:3 0:0 0:1 +y")), PairClass::adjacent);
}

TEST(PairClass, IsAdjacentWhereAnEdgeStandsOnTheOtherSurface) {
    EXPECT_EQ(class_of(floor_piece, rectangle("0.25:0.5 0.5:0.5 0:1 +y")), PairClass::adjacent);
}

TEST(PairClass, IsOtherWhereOnlyACornerOrNothingIsShared) {
    EXPECT_EQ(class_of(floor_piece, rectangle("1:2 0:0 0:1 +y")), PairClass::other);
    EXPECT_EQ(class_of(floor_piece, rectangle("0:1 0:0 0.5:1 +y")), PairClass::other);
    EXPECT_EQ(class_of(floor_piece, rectangle("0:1 -1:-1 0:1 +y")), PairClass::other);
}

TEST(PairClass, FindsTheSharedEdgeOfAnyTwoPlanesFarFromTheOrigin) {
    // A wedge of 60 degrees with slanting sides, turned and moved away; its edge lies along edge_u.
    const Eigen::Quaterniond turn(0.1, 0.5, -0.3, 0.8);
    const Eigen::Matrix3d rotation = turn.normalized().toRotationMatrix();
    const Eigen::Vector3d corner(100, -250, 30);
    const auto wing = [&](double angle, double begin) {
        const Eigen::AngleAxisd opening(angle, Eigen::Vector3d::UnitX());
        return Surface{
            Parallelogram{corner + rotation * Eigen::Vector3d(begin, 0, 0), rotation * Eigen::Vector3d(1, 0, 0),
                          rotation * (opening * Eigen::Vector3d(0.3, 1, 0))},
            rotation * (opening * Eigen::Vector3d(0, 0, 1)), 0};
    };
    EXPECT_EQ(class_of(wing(0, 0), wing(std::numbers::pi / 3, 0)), PairClass::adjacent);
    EXPECT_EQ(class_of(wing(0, 0), wing(std::numbers::pi / 3, 0.5)), PairClass::adjacent);
    EXPECT_EQ(class_of(wing(0, 0), wing(std::numbers::pi / 3, 1.5)), PairClass::other);
    EXPECT_EQ(class_of(wing(0, 0), wing(0, 1.5)), PairClass::parallel);
}

TEST(PairClass, LooksAtAllSurfacesOfAFace) {
    Scene scene = scene_of({floor_piece, rectangle("0:1 0:1 1:1 -z"), rectangle("0:1 0:0 0.5:1 +y")});
    EXPECT_EQ(pair_class(scene, 0, 1), PairClass::parallel);
    scene.surfaces[2].face = 1;
    EXPECT_EQ(pair_class(scene, 0, 1), PairClass::other) << "one of two surfaces is not parallel";
    scene.surfaces[2] = rectangle("0:1 0:0 0:1 +y");
    scene.surfaces[2].face = 1;
    EXPECT_EQ(pair_class(scene, 0, 1), PairClass::adjacent) << "one of two surfaces shares an edge";
}

TEST(PairClass, HasANameForEachClass) {
    EXPECT_EQ(name(PairClass::self), "self");
    EXPECT_EQ(name(PairClass::parallel), "parallel");
    EXPECT_EQ(name(PairClass::adjacent), "adjacent");
    EXPECT_EQ(name(PairClass::other), "other");
}

}  // namespace
}  // namespace ff

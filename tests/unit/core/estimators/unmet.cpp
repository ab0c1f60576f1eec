#include "core/estimators/unmet.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <numbers>

namespace ff {
namespace {

/// A large square, and a small one above its middle that looks down on it.
Scene lamp_above_floor(double edge, double lamp, double height) {
    const double low = (edge - lamp) / 2;
    Scene scene;
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{low, low, height}, {lamp, 0, 0}, {0, lamp, 0}}, {0, 0, -1}, 1}};
    scene.faces = {"floor", "lamp"};
    return scene;
}

TEST(Unmet, IsZeroWhereMostPointsSeeMuchOfTheOtherFace) {
    const Scene cube = make_box(1, 1, 1);
    for (int to = 1; to < 6; ++to) {
        EXPECT_EQ(largest_unmet_factor(cube, 0, to, 100), 0) << to;
        EXPECT_EQ(largest_unmet_hit(cube, 0, to, 5000, 2), 0) << to;
    }
}

// The factor from the floor to the lamp comes from some 1e-5 of the points of the floor: some of a million points are
// among them, but none of a thousand.
TEST(Unmet, IsThePeakOfASmallFaceCloseToALargeOne) {
    const Scene scene = lamp_above_floor(100, 0.2, 0.2);
    EXPECT_DOUBLE_EQ(largest_unmet_factor(scene, 0, 1, 1000), 1 / std::numbers::pi);
    EXPECT_EQ(largest_unmet_factor(scene, 0, 1, 1e7), 0);
    EXPECT_DOUBLE_EQ(largest_unmet_kernel(scene, 0, 1, 1000), largest_kernel(scene, 0, 1));
    EXPECT_EQ(largest_unmet_kernel(scene, 0, 1, 1e7), 0);
    EXPECT_EQ(largest_unmet_factor(scene, 1, 0, 100), 0) << "all points of the lamp see the floor alike";
}

TEST(Unmet, HasAPeakForEachSurfaceOfAFace) {
    Scene scene = lamp_above_floor(100, 0.2, 0.2);
    scene.surfaces.push_back({Parallelogram{{0, 0, 60}, {100, 0, 0}, {0, 100, 0}}, {0, 0, -1}, 1});
    scene.empty_box = Eigen::Vector3d(100, 100, 60);  // leaves out what the lamp hides
    EXPECT_DOUBLE_EQ(largest_unmet_factor(scene, 0, 1, 1000), 1);
    EXPECT_EQ(largest_unmet_factor(scene, 0, 1, 1e7), 0);
}

TEST(Unmet, IncludesHitsWhereFewAreExpected) {
    const Scene tube = make_box(1, 1, 16);
    EXPECT_EQ(largest_unmet_hit(tube, 0, 5, 2000, 2), 2);
    EXPECT_EQ(largest_unmet_hit(tube, 0, 5, 2e6, 2), 0);
}

TEST(Unmet, IsTheSameWhereTheSceneIsTurned) {
    Scene scene = lamp_above_floor(100, 0.2, 0.2);
    const double kernel = largest_unmet_kernel(scene, 0, 1, 1000);
    const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
    for (Surface& surface : scene.surfaces) {
        auto& shape = std::get<Parallelogram>(surface.shape);
        shape = {turn * shape.corner, turn * shape.edge_u, turn * shape.edge_v};
        surface.normal = turn * surface.normal;
    }
    EXPECT_NEAR(largest_unmet_kernel(scene, 0, 1, 1000), kernel, 1e-9 * kernel);
    EXPECT_NEAR(largest_unmet_factor(scene, 0, 1, 1000), 1 / std::numbers::pi, 1e-12);
}

TEST(Unmet, KnowsTheGapBetweenRoundSurfacesWithinEachOther) {
    Scene balls;
    balls.surfaces = {{SphereZone{{0, 0, 0}, {0, 0, 1}, 1, -1, 1, Facing::inward}, {0, 0, 0}, 0},
                      {SphereZone{{0, 0, 0.5}, {0, 0, 1}, 0.49, -1, 1, Facing::outward}, {0, 0, 0}, 1}};
    balls.faces = {"shell", "ball"};
    EXPECT_NEAR(largest_kernel(balls, 0, 1), 4 * 0.49 * 0.49 / (0.01 * 0.01), 1e-6);
    Scene tubes;
    tubes.surfaces = {{Frustum{{0, 0, 0}, {0, 0, 2}, 1, 1, Facing::inward}, {0, 0, 0}, 0},
                      {Frustum{{0, 0, 0}, {0, 0, 2}, 0.9, 0.5, Facing::outward}, {0, 0, 0}, 1}};
    tubes.faces = {"pipe", "core"};
    EXPECT_NEAR(largest_kernel(tubes, 1, 0), 4 * std::numbers::pi / (std::numbers::pi * 0.1 * 0.1), 1e-6);
}

}  // namespace
}  // namespace ff

#include "core/visibility/level_overlaps.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/visibility/occlusion.hpp"

#include "core/geometry/box.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <numbers>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface level_rectangle(double x, double y, double width, double depth, double height = 0, bool down = false) {
    return {Parallelogram{{x, y, height}, {width, 0, 0}, {0, depth, 0}}, {0, 0, down ? -1.0 : 1.0}, 0};
}

Scene turned(Scene scene) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(0.3, 0.5, std::sqrt(0.66))).toRotationMatrix();
    for (Surface& surface : scene.surfaces) {
        surface.normal = turn * surface.normal;
        if (auto* p = std::get_if<Parallelogram>(&surface.shape))
            *p = {turn * p->corner, turn * p->edge_u, turn * p->edge_v};
        if (auto* p = std::get_if<Disc>(&surface.shape)) p->centre = turn * p->centre;
    }
    return scene;
}

TEST(LevelOverlaps, AreFoundWithTheirArea) {
    for (const bool down : {false, true}) {
        const auto found = level_overlaps(
            turned(test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(0.8, 0.5, 2, 2, 0, down)}, false)));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].same_side, !down);
        EXPECT_NEAR(found[0].area, 0.1, 1e-12);
    }
}

TEST(LevelOverlaps, ExcludeAdjacentAndSeparateSurfaces) {
    EXPECT_TRUE(level_overlaps(make_box(3, 2, 1)).empty());
    const Scene apart = test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(1, 0, 1, 1),
                                        level_rectangle(0, 1, 1.7, 1), level_rectangle(0.2, 0.2, 0.2, 0.2, 1e-6)},
                                       false);
    EXPECT_TRUE(level_overlaps(apart).empty());
    EXPECT_TRUE(level_overlaps(turned(apart)).empty());
}

// Nothing is silently counted twice: a surface just above another either hides it or counts as level with it.
TEST(LevelOverlaps, AreLevelWithinTheToleranceOfOcclusion) {
    for (const double height : {0.0, 1e-15, 1e-14, 1e-13, 1e-12, 3e-12, 1e-11, 1e-10, 1e-8, 1e-7}) {
        const Scene scene =
            turned(test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(0.2, 0.2, 0.2, 0.2, height),
                                   level_rectangle(0, 0, 1, 1, 1, true)},
                                  false));
        const auto found = level_overlaps(scene);
        ASSERT_EQ(found.size(), 1u) << height;
        const bool hides = !LinesBetween(scene.surfaces[0], scene.surfaces[2]).keep_clear_of(scene.surfaces[1]);
        EXPECT_TRUE(hides || found[0].level) << height;
        EXPECT_EQ(found[0].level, height <= level_gap(scene)) << height;
    }
}

TEST(LevelOverlaps, AreLevelWithinTheRoundingOfCoordinates) {
    Scene scene = test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(0.2, 0.2, 0.2, 0.2, 1e-7)}, false);
    EXPECT_FALSE(level_overlaps(scene).front().level);
    scene.coordinate_rounding = 1e-7;
    EXPECT_TRUE(level_overlaps(scene).front().level);
}

TEST(LevelOverlaps, AreInDoubtWithinTwoStepsOnSlantingPlanes) {
    for (const double height : {0.0, 0.3e-3, -1.9e-3, 2.1e-3}) {
        Scene scene =
            test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(0.2, 0.2, 0.2, 0.2, height, true)}, false);
        scene.coordinate_step = 1e-3;
        EXPECT_EQ(level_overlaps(scene).size(), height == 0 ? 1 : 0) << height;
        const auto found = level_overlaps(turned(scene));
        ASSERT_EQ(found.size(), height > 2e-3 ? 0 : 1) << height;
        for (const LevelOverlap& overlap : found) EXPECT_EQ(overlap.in_doubt, height != 0) << height;
    }
}

// What is certain is that rounding explains neither much of a surface, nor what is wide, nor edges along axes.
TEST(LevelOverlaps, AreExplainedByRoundingAlongSlantingEdges) {
    const auto explained = [](double over, double width, double angle) {
        Scene scene = test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(1 - over, 0, width, 1)}, false);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
        for (Surface& surface : scene.surfaces) {
            auto& shape = std::get<Parallelogram>(surface.shape);
            shape = {turn * shape.corner, turn * shape.edge_u, turn * shape.edge_v};
        }
        scene.coordinate_step = 1e-3;
        const auto found = level_overlaps(scene);
        EXPECT_EQ(found.size(), 1u);
        return !found.empty() && found[0].by_rounding;
    };
    EXPECT_TRUE(explained(1e-3, 1, 0.4));
    EXPECT_FALSE(explained(6e-3, 1, 0.4)) << "too wide";
    EXPECT_FALSE(explained(1e-3, 4e-3, 0.4)) << "a quarter of a strip";
    EXPECT_FALSE(explained(1e-3, 1, 0)) << "along axes";
}

// The plane of a small surface is known less well than its place: at the far end of a wall it may be far off.
TEST(LevelOverlaps, AreFoundForSmallSurfacesInTheRoundingOfTheirCorners) {
    for (const double size : {1e-1, 1e-4, 1e-7, 1e-10}) {
        Scene scene = turned(
            test::faces_of({level_rectangle(0, 0, 1, 1), level_rectangle(0.3, 0.7, size, size, 0, true)}, false));
        const ConvexPolygon rounded = corners(scene.surfaces[1].shape);
        scene.surfaces[1].normal = (rounded[2] - rounded[1]).cross(rounded[1] - rounded[0]).normalized();
        const auto found = level_overlaps(scene);
        ASSERT_EQ(found.size(), 1u) << size;
        EXPECT_TRUE(found[0].level) << size;
    }
}

TEST(LevelOverlaps, AreFoundForDiscs) {
    const Vector3d up(0, 0, 1);
    const Scene rings = test::faces_of({test::disc({0, 0, 0}, up, 2, 1), test::disc({0, 0, 0}, up, 1)}, false);
    EXPECT_TRUE(level_overlaps(turned(rings)).empty()) << "a disc in the hole of a ring";
    const Scene over = test::faces_of({test::disc({0, 0, 0}, up, 2), level_rectangle(-0.5, -0.5, 1, 1)}, false);
    const auto found = level_overlaps(turned(over));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].area, 1, 0.1);
}

}  // namespace
}  // namespace ff

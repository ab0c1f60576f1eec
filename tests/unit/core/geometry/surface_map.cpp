#include "core/geometry/surface_map.hpp"

#include "core/geometry/unit_circle.hpp"
#include "core/visibility/touching.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

std::vector<Surface> one_of_each() {
    const Vector3d normal = Vector3d(1, 2, 0.5).cross(Vector3d(-0.4, 0.7, 1.1)).normalized();
    return {
        {Parallelogram{{0.3, -1, 2}, {1, 2, 0.5}, {-0.4, 0.7, 1.1}}, normal, 0},
        {Triangle{{0.3, -1, 2}, {1.3, 1, 2.5}, {-0.1, -0.3, 3.1}}, normal, 0},
        test::disc({1, 2, 3}, test::tilted, 0.7),
        test::disc({1, 2, 3}, -test::tilted, 0.7, 0.3),
        test::wall({1, 2, 3}, 2 * test::tilted, 0.5, 0.5, Facing::inward),
        test::wall({1, 2, 3}, 2 * test::tilted, 0.5, 1.5, Facing::outward),
        test::wall({1, 2, 3}, 2 * test::tilted, 0.5, 0, Facing::inward),
        test::wall({1, 2, 3}, 0.01 * test::tilted, 0, 2, Facing::outward),
        test::sphere({1, 2, 3}, 0.8, Facing::outward),
        test::sphere({1, 2, 3}, 0.8, Facing::inward, 0.3),
        test::sphere({1, 2, 3}, 0.8, Facing::inward, -0.9, -0.2),
    };
}

/// Inside the unit square, where the map is smooth.
template <class Visit>
void at_random_places(Visit visit) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> coordinate(0.02, 0.98);
    for (int i = 0; i < 200; ++i) {
        const double s = coordinate(engine);
        visit(s, coordinate(engine));
    }
}

// The area that a small square is stretched to does not depend on where it lies. Central differences with steps of 1e-4
// are off by 1e-8 times a third derivative, which is below 1e5 at s = 0.02.
TEST(SurfaceMap, StretchesEveryPartOfTheSquareToTheSameArea) {
    constexpr double step = 1e-4;
    for (const Surface& surface : one_of_each()) {
        const SurfaceMap map(surface);
        at_random_places([&](double s, double t) {
            const Vector3d along_s = map.at(s + step, t).position - map.at(s - step, t).position;
            const Vector3d along_t = map.at(s, t + step).position - map.at(s, t - step).position;
            const double stretched = along_s.cross(along_t).norm() / (4 * step * step);
            EXPECT_NEAR(stretched / area(surface.shape), 1, 1e-3) << surface.shape.index();
            EXPECT_NEAR(map.at(s, t).normal.dot(along_s.cross(along_t).normalized()) *
                            map.at(s, t).normal.dot(along_s.cross(along_t).normalized()),
                        1, 1e-6);
        });
    }
}

TEST(SurfaceMap, LeadsToPlacesOnTheSurface) {
    for (const Surface& surface : one_of_each()) {
        const SurfaceMap map(surface);
        at_random_places([&](double s, double t) {
            EXPECT_TRUE(lies_on(map.at(s, t).position, surface, 1e-14)) << surface.shape.index();
            EXPECT_NEAR(map.at(s, t).normal.norm(), 1, 1e-15);
            EXPECT_NEAR(map.at(s, t).tangent.dot(map.at(s, t).normal), 0, 1e-15);
            EXPECT_NEAR(map.at(s, t).tangent.norm(), 1, 1e-15);
        });
    }
}

TEST(SurfaceMap, FindsTheCoordinatesOfAPlaceAgain) {
    for (const Surface& surface : one_of_each()) {
        const SurfaceMap map(surface);
        at_random_places([&](double s, double t) {
            const auto [found_s, found_t] = map.coordinates(map.at(s, t).position);
            EXPECT_NEAR(found_s, s, 1e-12) << surface.shape.index();
            EXPECT_NEAR(found_t, t, 1e-12) << surface.shape.index();
        });
    }
}

TEST(SurfaceMap, PointsNormalsToTheRadiatingSide) {
    const SurfaceMap outside(test::sphere({0, 0, 0}, 2, Facing::outward));
    EXPECT_GT(outside.at(0.3, 0.6).normal.dot(outside.at(0.3, 0.6).position), 0);
    const SurfaceMap inside(test::wall({0, 0, 0}, {0, 0, 1}, 1, 0, Facing::inward));
    EXPECT_LT(inside.at(0.3, 0.6).normal.z(), 0) << "of a cone from inside: down and towards the axis";
}

TEST(SurfaceMap, ReachesTheCornersOfTheSquare) {
    for (const Surface& surface : one_of_each()) {
        const SurfaceMap map(surface);
        for (const double s : {0.0, 1.0}) {
            for (const double t : {0.0, 1.0}) {
                EXPECT_TRUE(lies_on(map.at(s, t).position, surface, 1e-14)) << surface.shape.index();
                EXPECT_TRUE(map.at(s, t).tangent.allFinite());
            }
        }
    }
}

// The greatest product among 250 000 places on a grid; between grid points a round shape rises by at most
// 1 - cos(2 pi / 1000) of its size.
TEST(Extent, IsTheFarthestReachOfTheSurface) {
    for (const Surface& surface : one_of_each()) {
        const SurfaceMap map(surface);
        for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(-0.3, 0.7, 2), Vector3d(0.36, 0.48, 0.81)}) {
            double highest = -1e300;
            for (int i = 0; i <= 500; ++i) {
                for (int j = 0; j <= 500; ++j) {
                    highest = std::max(highest, direction.dot(map.at(i / 500.0, j / 500.0).position));
                }
            }
            const Extent found = extent(surface, direction);
            EXPECT_GE(found.high, highest - 1e-12) << surface.shape.index();
            // Along s a grid step near a pole is as wide as sqrt(1 / 500).
            EXPECT_LE(found.high, highest + 5e-3 * direction.norm()) << surface.shape.index();
            EXPECT_EQ(found.high, -extent(surface, -direction).low);
        }
    }
}

TEST(UnitCircle, AgreesWithSineAndCosine) {
    for (int i = 0; i <= 4000; ++i) {
        const double turns = i / 4000.0;
        const auto [cosine, sine] = unit_circle(turns);
        EXPECT_NEAR(cosine, static_cast<double>(std::cos(2 * std::numbers::pi_v<long double> * turns)), 3e-16);
        EXPECT_NEAR(sine, static_cast<double>(std::sin(2 * std::numbers::pi_v<long double> * turns)), 3e-16);
    }
}

TEST(Perpendicular, IsTheNearestToACoordinateAxis) {
    EXPECT_EQ(perpendicular({0, 0, 2}), Vector3d(1, 0, 0));
    EXPECT_EQ(perpendicular({3, 0, 0}), Vector3d(0, 1, 0));
    EXPECT_NEAR(perpendicular({1, 1, 1}).dot(Vector3d(1, 1, 1)), 0, 1e-15);
}

}  // namespace
}  // namespace ff

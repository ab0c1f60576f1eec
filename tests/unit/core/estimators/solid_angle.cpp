#include "core/estimators/pairs/solid_angle.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/estimator_trials.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

using Eigen::Vector3d;

SphericalTriangle seen(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return spherical_triangle(a, b, c, std::abs(a.dot(b.cross(c))));
}

TEST(SphericalTriangle, HasTheAreaOfAnOctant) {
    EXPECT_DOUBLE_EQ(2 * seen({3, 0, 0}, {0, 0.1, 0}, {0, 0, 7}).half_area, std::numbers::pi / 2);
}

// A flat triangle of area 1/2, with its right angle below the centre, from a height of 1e4: area over height squared,
// to within 1e-8 of it. The formula keeps all digits of distant triangles.
TEST(SphericalTriangle, KeepsItsDigitsWhereItIsSmall) {
    const double height = 1e4;
    const double area = 2 * spherical_triangle({0, 0, height}, {1, 0, height}, {0, 1, height}, height).half_area;
    EXPECT_NEAR(area * 2 * height * height, 1, 1e-8);
    EXPECT_LT(area * 2 * height * height, 1);
}

TEST(SphericalTriangle, FillsTheHemisphereFromAPlaceOnTheTriangle) {
    const Vector3d a{1, 0, -1e-12}, b{-0.5, 0.8, -1e-12}, c{-0.5, -0.8, -1e-12};
    EXPECT_NEAR(2 * seen(a, b, c).half_area, 2 * std::numbers::pi, 1e-10);
}

/// Whether a direction lies within the triangle.
bool holds(const SphericalTriangle& triangle, const Vector3d& direction) {
    const auto& [a, b, c, half_area] = triangle;
    const double side = a.dot(b.cross(c)) > 0 ? 1 : -1;
    return side * direction.dot(a.cross(b)) > -1e-12 && side * direction.dot(b.cross(c)) > -1e-12 &&
           side * direction.dot(c.cross(a)) > -1e-12;
}

TEST(DirectionIn, LeadsIntoTheTriangleAndHasUnitLength) {
    for (const double size : {1.0, 1e-3, 1e-6}) {
        const auto triangle = seen({size, 0, 1}, {0, size, 1}, {-size, -0.3 * size, 1});
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 20; ++j) {
                const Vector3d direction = direction_in(triangle, i / 20.0, j / 20.0);
                EXPECT_NEAR(direction.norm(), 1, 1e-14);
                EXPECT_TRUE(holds(triangle, direction)) << size << ' ' << i << ' ' << j;
            }
        }
    }
}

// The part of the square below s and t is a part of the triangle with s * t of its area: directions at s = 1/2 end on
// an arc that halves it. The same for triangles of a degree and of an octant.
TEST(DirectionIn, PreservesSharesOfArea) {
    for (const double size : {1e-5, 0.02, 1.0, 30.0}) {
        const auto triangle = seen({size, 0, 1}, {0, size, 1}, {-size, -0.3 * size, 1});
        for (const double share : {0.1, 0.5, 0.9}) {
            const Vector3d end = direction_in(triangle, share, 1);  // on the arc from a to c
            const auto part = seen(triangle.a, triangle.b, end);
            EXPECT_NEAR(part.half_area / triangle.half_area, share, 1e-9) << size;
        }
    }
}

// The mean direction of an octant, by the integral of its coordinates over it: 1/2 each. Near b the map goes as the
// root of t, so that midpoints leave an error of about n^-1.5, 9e-5.
TEST(DirectionIn, HasTheMeanDirectionOfAnOctant) {
    const auto octant = seen({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    Vector3d sum = Vector3d::Zero();
    constexpr int n = 512;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) sum += direction_in(octant, (i + 0.5) / n, (j + 0.5) / n);
    }
    for (const double mean : Vector3d(sum / (n * n))) EXPECT_NEAR(mean, 0.5, 1e-4);
}

// On a small and distant target the cosine and the solid angle hardly change: one point is accurate to about the size
// over the distance.
TEST(SolidAngle, NeedsOnlyOnePointOnASmallTarget) {
    Scene scene;
    scene.faces = {"near", "far"};
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{0, 0, 1}, {0, 1e-3, 0}, {1e-3, 0, 0}}, {0, 0, -1}, 1}};
    EXPECT_NEAR(test::observe<SolidAngle>(scene, 1, 1).estimates(0, 1) * std::numbers::pi / 1e-6, 1, 1e-5);
}

TEST(SolidAngle, GivesNoFactorAboveTwo) {
    const Eigen::MatrixXd factors = test::observe<SolidAngle>(make_box(1, 1, 1e-3), 1, 64).estimates;
    EXPECT_LE(factors.maxCoeff(), 2);
    EXPECT_TRUE(factors.diagonal().isZero(0));
}

TEST(SolidAngle, RefusesCurvedFaces) {
    Scene scene;
    scene.name = "discs";
    scene.faces = {"a"};
    scene.surfaces = {{Disc{{0, 0, 0}, 0, 1}, {0, 0, 1}, 0}};
    EXPECT_NE(
        find_estimator("solid_angle").refusal({}, scene).find("not all of its faces are parallelograms and triangles"),
        std::string::npos);
}

}  // namespace
}  // namespace ff

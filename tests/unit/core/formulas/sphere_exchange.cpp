#include "core/formulas/sphere_exchange.hpp"

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "tests/support/round_scenes.hpp"
#include "tests/support/unit_cube.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;
using test::disc;
using test::wall_at;

Surface ball(const Vector3d& centre, double radius) {
    return test::sphere(centre, radius, Facing::outward);
}

/// The value where it is known so well, or -1.
double sphere_exchange(const Surface& from, const Surface& to, double wanted = 1e-13) {
    const auto area = sphere_exchange_area(from, to, wanted);
    return area && area->error <= wanted ? area->value : -1;
}

TEST(SphereExchange, IsTheSolidAngleOfWhatASphereSees) {
    const double radius = 0.2;
    const auto cap = [](double h, double a) { return 2 * std::numbers::pi * (1 - h / std::hypot(h, a)); };
    const double expected = radius * radius * cap(0.5, 1);
    EXPECT_NEAR(sphere_exchange(ball({1, 1, 1}, radius), disc({1, 1, 1.5}, {0, 0, -1}, 1)), expected, 1e-14);
    EXPECT_NEAR(sphere_exchange(disc({1, 1, 1.5}, {0, 0, -1}, 1), ball({1, 1, 1}, radius)), expected, 1e-14);
    // From anywhere in a box its walls receive all that leaves.
    const Vector3d centre(0.3, 0.75, 0.4);
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    double sum = 0;
    for (const auto& [corner, u, v] : {std::tuple(Vector3d(0, 0, 0), x, y),
                                       {Vector3d(0, 0, 1), y, x},
                                       {Vector3d(0, 0, 0), y, z},
                                       {Vector3d(1, 0, 0), z, y},
                                       {Vector3d(0, 0, 0), z, x},
                                       {Vector3d(0, 1, 0), x, z}})
        sum += sphere_exchange(ball(centre, radius), wall_at(corner, u, v));
    EXPECT_NEAR(sum, 4 * std::numbers::pi * radius * radius, 1e-13);
    // A disc beside the axis, against its sectors in many triangles: they leave a share of (2 std::numbers::pi / n)^2
    // / 6.
    const Surface eccentric = disc({0.9, 0, -0.5}, {0, 0, 1}, 0.7, 0.1);
    double triangles = 0;
    const int n = 4000;
    for (const auto& [r, sign] : {std::pair(0.7, 1.0), std::pair(0.1, -1.0)}) {
        const auto at = [r = r](int k) {
            return Vector3d(0.9 + r * std::cos(2 * std::numbers::pi * k / n),
                            r * std::sin(2 * std::numbers::pi * k / n), -0.5);
        };
        for (int k = 0; k < n; ++k)
            triangles += sign * sphere_exchange(ball({0, 0, 0}, radius),
                                                {Triangle{{0.9, 0, -0.5}, at(k), at(k + 1)}, {0, 0, 1}, 0});
    }
    EXPECT_NEAR(sphere_exchange(ball({0, 0, 0}, radius), eccentric), triangles, 1e-6 * triangles);
}

TEST(SphereExchange, IsWhatASphereSendsToWallsAroundIt) {
    // Anywhere in a tilted can with a conical shoulder and a domed end, all that leaves a sphere arrives.
    const auto up = [](double height) { return Vector3d(test::somewhere + height * test::tilted); };
    const double radius = 0.1;
    for (const auto& [height, off] : {std::pair(0.2, 0.3), std::pair(1.5, 0.85), std::pair(2.6, 0.2)}) {
        const Surface inner = ball(up(height) + off * perpendicular(test::tilted), radius);
        double sum = 0;
        for (const Surface& part : {disc(up(0), test::tilted, 1), test::wall(up(0), test::tilted, 1, 1, Facing::inward),
                                    test::wall(up(2), -test::tilted, 1, 1, Facing::inward),
                                    test::wall(up(2), 0.5 * test::tilted, 1, 0.8, Facing::inward),
                                    test::sphere(up(1.9), 1, Facing::inward, 0.6, 1)}) {
            const double area = sphere_exchange(inner, part, 1e-11);
            EXPECT_GE(area, 0) << height;
            EXPECT_EQ(area, sphere_exchange(part, inner, 1e-11)) << height;
            sum += area;
        }
        EXPECT_NEAR(sum, 4 * std::numbers::pi * radius * radius, 1e-10) << height;
    }
    const Surface outer = test::sphere({0, 0, 0}, 1, Facing::inward);
    EXPECT_NEAR(sphere_exchange(ball({0.3, 0.2, 0.1}, 0.5), outer), std::numbers::pi, 1e-13);
    EXPECT_FALSE(sphere_exchange_area(ball({0.9, 0, 0}, 0.2), outer, 1e-9)) << "it reaches through";
    EXPECT_FALSE(
        sphere_exchange_area(ball({0, 0, 0}, 0.2), test::wall({0, 0, -1}, {0, 0, 2}, 1, 1, Facing::outward), 1e-9));
}

TEST(SphereExchange, IsEmptyWhereItIsNotKnown) {
    const Surface floor = wall_at({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    EXPECT_FALSE(sphere_exchange_area(ball({0, 0, 0.1}, 0.2), floor, 1e-9)) << "partly behind";
    EXPECT_FALSE(sphere_exchange_area(ball({0, 0, 1}, 0.2), ball({0, 0, 2}, 0.2), 1e-9));
    EXPECT_FALSE(sphere_exchange_area(test::sphere({0, 0, 1}, 0.2, Facing::outward, -1, 0.5), floor, 1e-9))
        << "not whole";
}

}  // namespace
}  // namespace ff

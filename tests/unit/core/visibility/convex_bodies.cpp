#include "core/visibility/bodies.hpp"

#include "tests/support/unit_cube.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using test::unit_cube;
using test::wall_at;

std::vector<Vector3d> square_at(double height, double size) {
    return {{-size, -size, height}, {size, -size, height}, {size, size, height}, {-size, size, height}};
}

ConvexBodies bodies_of(const std::vector<Surface>& sides) {
    return {sides, SharedEdges(sides)};
}

TEST(ConvexBodies, AreClosedOrLackOneSide) {
    std::vector<Surface> sides = unit_cube();
    for (std::size_t k = 0; k < sides.size(); ++k) EXPECT_EQ(bodies_of(sides).of(k), 0u);
    sides.erase(sides.begin());
    for (std::size_t k = 0; k < sides.size(); ++k) EXPECT_EQ(bodies_of(sides).of(k), 0u) << "without a floor";
    sides.pop_back();
    for (std::size_t k = 0; k < sides.size(); ++k) EXPECT_FALSE(bodies_of(sides).of(k)) << "without a wall too";
}

TEST(ConvexBodies, ExcludeBodiesThatRadiateInwards) {
    std::vector<Surface> sides = unit_cube();
    for (Surface& surface : sides) surface.normal *= -1;
    for (std::size_t k = 0; k < sides.size(); ++k) EXPECT_FALSE(bodies_of(sides).of(k));
}

TEST(ConvexBodies, ExcludeTheFloorTheyStandOn) {
    std::vector<Surface> sides = unit_cube();
    sides.erase(sides.begin());
    sides.push_back(wall_at({1, 0, 0}, {1, 0, 0}, {0, 1, 0}));  // shares an edge with the wall
    const ConvexBodies bodies = bodies_of(sides);
    EXPECT_EQ(bodies.of(0), 0u);
    EXPECT_FALSE(bodies.of(sides.size() - 1));
}

TEST(ConvexBodies, HaveAnOutside) {
    const ConvexBodies bodies = bodies_of(unit_cube());
    EXPECT_TRUE(bodies.is_outside(0, square_at(3, 0.1)));
    EXPECT_FALSE(bodies.is_outside(0, square_at(0.5, 0.1))) << "half of that square is inside";
    EXPECT_FALSE(bodies.is_outside(0, square_at(1, 0.1))) << "a lamp below the roof, which is at its back";
}

TEST(ConvexBodies, LetLinesInWhereASideIsMissing) {
    std::vector<Surface> sides = unit_cube();
    sides.erase(sides.begin());
    const ConvexBodies bodies = bodies_of(sides);
    EXPECT_FALSE(bodies.is_outside(0, square_at(-1, 0.1))) << "nothing stands before the roof there";
    EXPECT_TRUE(bodies.is_outside(0, std::vector<Vector3d>{{3, 0, 0.1}, {3, 1, 0.1}, {3, 1, 0.9}, {3, 0, 0.9}}));
}

}  // namespace
}  // namespace ff

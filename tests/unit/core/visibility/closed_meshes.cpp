#include "core/visibility/bodies.hpp"

#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// A closed body of eight triangles: an octahedron whose upper peak is pushed in or pulled out.
std::vector<Surface> octahedron(const Vector3d& peak, bool outward = true) {
    const std::array<Vector3d, 4> ring{Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(-1, 0, 0), Vector3d(0, -1, 0)};
    std::vector<Surface> sides;
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        Triangle triangle{a, b, c};
        if (!outward) std::swap(triangle.b, triangle.c);
        sides.push_back({triangle, (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized(), no_face});
    };
    for (std::size_t k = 0; k < 4; ++k) {
        add(ring[k], ring[(k + 1) % 4], peak);
        add(ring[(k + 1) % 4], ring[k], {0, 0, -1});
    }
    return sides;
}

ClosedMeshes meshes_of(const std::vector<Surface>& surfaces) {
    return ClosedMeshes(SharedEdges(surfaces));
}

const std::vector<Vector3d> high_up{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}};

TEST(ClosedMeshes, MayHaveDents) {
    for (const double peak : {1.0, 0.2, -0.5}) {
        const ClosedMeshes meshes = meshes_of(octahedron({0, 0, peak}));
        ASSERT_EQ(meshes.size(), 1u) << peak;
        EXPECT_EQ(meshes.of(3), 0u);
    }
}

TEST(ClosedMeshes, HaveNoMissingSide) {
    std::vector<Surface> sides = octahedron({0, 0, 1});
    sides.pop_back();
    EXPECT_EQ(meshes_of(sides).size(), 0u);
}

TEST(ClosedMeshes, TurnAllSidesTheSameWay) {
    std::vector<Surface> sides = octahedron({0, 0, 1});
    auto& triangle = std::get<Triangle>(sides.back().shape);
    std::swap(triangle.b, triangle.c);
    sides.back().normal *= -1;
    EXPECT_EQ(meshes_of(sides).size(), 0u);
}

TEST(ClosedMeshes, DoNotCutThroughThemselves) {
    EXPECT_EQ(meshes_of(octahedron({0.9, 0, -0.6})).size(), 0u) << "the upper peak pierces a lower side";
}

TEST(ClosedMeshes, AreSeenFromTheFreeSide) {
    std::vector<Surface> sides = octahedron({0, 0, 0.2});
    sides.push_back({Triangle{high_up[0], high_up[1], high_up[2]}, -Vector3d::UnitZ(), no_face});
    const ClosedMeshes body = meshes_of(sides);
    EXPECT_TRUE(body.is_on_free_side(0, 8, high_up));
    EXPECT_TRUE(body.is_on_free_side(0, 0, outline(sides[0]))) << "of itself";
    const std::vector<Vector3d> within{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    EXPECT_FALSE(body.is_on_free_side(0, 8, within));
    const std::vector<Vector3d> level{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}};
    EXPECT_FALSE(body.is_on_free_side(0, 8, level)) << "the body stands on it";
    std::vector<Surface> walls = octahedron({0, 0, 0.2}, false);
    walls.push_back(sides.back());
    const ClosedMeshes cave = meshes_of(walls);
    EXPECT_FALSE(cave.is_on_free_side(0, 8, high_up)) << "behind its walls";
    EXPECT_TRUE(cave.is_on_free_side(0, 0, outline(walls[0])));
}

}  // namespace
}  // namespace ff

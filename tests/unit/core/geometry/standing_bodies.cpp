#include "core/geometry/standing_bodies.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/surface_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr double gap = 1e-12;

/// A rectangle from two edges, which radiates to the side of their cross product.
Surface side(const Vector3d& corner, const Vector3d& u, const Vector3d& v, int face) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), face};
}

/// The sides of a box that face outwards, then its top and its bottom.
std::vector<Surface> body(const Vector3d& at, const Vector3d& size, int face) {
    const Vector3d x(size.x(), 0, 0);
    const Vector3d y(0, size.y(), 0);
    const Vector3d z(0, 0, size.z());
    return {side(at, x, z, face),      side(at + x, y, z, face), side(at + x + y, -x, z, face),
            side(at + y, -y, z, face), side(at + z, x, y, face), side(at, y, x, face)};
}

/// A floor of 4 x 4 in two tiles that faces up, face 0; what stands on it belongs to face 1.
Scene floor_with(const std::vector<Surface>& above) {
    Scene scene;
    scene.faces = {"floor", "above"};
    scene.surfaces = {side({0, 0, 0}, {2, 0, 0}, {0, 4, 0}, 0), side({2, 0, 0}, {2, 0, 0}, {0, 4, 0}, 0)};
    scene.surfaces.insert(scene.surfaces.end(), above.begin(), above.end());
    return scene;
}

double area_left(const Scene& scene, const StandingBodies& found, int face) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        if (scene.surfaces[i].face != face) continue;
        if (!found.any() || !found.left[i]) {
            sum += area(scene.surfaces[i].shape);
        } else {
            for (const ConvexPolygon& polygon : *found.left[i]) {
                EXPECT_GT(twice_area(polygon).dot(scene.surfaces[i].normal), 0) << "it faces where it did";
                sum += twice_area(polygon).norm() / 2;
            }
        }
    }
    return sum;
}

TEST(StandingBodies, CoverTheFloorBeneathThem) {
    for (const bool has_bottom : {true, false}) {
        std::vector<Surface> box = body({1.5, 1, 0}, {1, 2, 0.5}, 1);
        const double walls = 2 * (0.5 + 1) + 2;
        if (!has_bottom) box.pop_back();
        const Scene scene = floor_with(box);
        const auto found = standing_bodies(scene, gap);
        EXPECT_NEAR(area_left(scene, found, 0), 14, 1e-12) << "across both tiles";
        EXPECT_NEAR(area_left(scene, found, 1), walls, 1e-12);
    }
}

TEST(StandingBodies, CoverTheFloorBeneathAnyOfTheirParts) {
    // An L of three unit squares, which has no bottom and is not convex.
    const std::vector<Vector3d> rim{{0.5, 0.5, 0}, {1.5, 0.5, 0}, {2.5, 0.5, 0}, {2.5, 1.5, 0},
                                    {1.5, 1.5, 0}, {1.5, 2.5, 0}, {0.5, 2.5, 0}, {0.5, 1.5, 0}};
    std::vector<Surface> l;
    for (std::size_t k = 0; k < rim.size(); ++k)
        l.push_back(side(rim[k], rim[(k + 1) % rim.size()] - rim[k], {0, 0, 1}, 1));
    for (const Vector3d& corner : {rim[0], rim[1], rim[7]})
        l.push_back(side(corner + Vector3d(0, 0, 1), {1, 0, 0}, {0, 1, 0}, 1));
    const Scene scene = floor_with(l);
    EXPECT_NEAR(area_left(scene, standing_bodies(scene, gap), 0), 16 - 3, 1e-12);
}

TEST(StandingBodies, StandOnEachOther) {
    std::vector<Surface> two = body({1, 1, 0}, {2, 2, 1}, 1);
    for (const Surface& surface : body({1.5, 1.5, 1}, {1, 1, 1}, 1)) two.push_back(surface);
    const Scene scene = floor_with(two);
    const auto found = standing_bodies(scene, gap);
    EXPECT_NEAR(area_left(scene, found, 0), 12, 1e-12);
    EXPECT_NEAR(area_left(scene, found, 1), 8 + 4 - 1 + 4 + 1, 1e-12);
}

TEST(StandingBodies, ExcludeThinWallsOpenTubesPicturesAndRooms) {
    const Scene wall = floor_with({side({1, 1, 0}, {0, 1, 0}, {1, 0, 0}, 1)});
    EXPECT_FALSE(standing_bodies(wall, gap).any()) << "the other side of the floor";
    std::vector<Surface> tube = body({1, 1, 0}, {1, 1, 1}, 1);
    tube.resize(4);
    EXPECT_FALSE(standing_bodies(floor_with(tube), gap).any()) << "light falls in from above";
    const Scene picture = floor_with({side({1, 1, 0}, {1, 0, 0}, {0, 1, 0}, 1)});
    EXPECT_FALSE(standing_bodies(picture, gap).any());
    Scene room = make_box(3, 2, 1);
    EXPECT_FALSE(standing_bodies(room, gap).any());
    const Scene above = floor_with(body({1, 1, 1e-9}, {1, 1, 1}, 1));
    EXPECT_FALSE(standing_bodies(above, gap).any()) << "it hovers";
    std::vector<Surface> beneath = body({1, 1, -1}, {1, 1, 1}, 1);
    EXPECT_FALSE(standing_bodies(floor_with(beneath), gap).any()) << "its top is the other side of the floor";
}

/// Each surface with its back: face 1 outside, face 2 inside. Polygons are halved across the one or the other diagonal.
std::vector<Surface> shell(const std::vector<Surface>& outside, bool in_triangles) {
    std::vector<Surface> both;
    for (const Surface& surface : outside) {
        const auto polygon = corners(surface.shape);
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c, int face) {
            both.push_back({Triangle{polygon[a], polygon[b], polygon[c]}, surface.normal * (face == 1 ? 1 : -1), face});
        };
        if (in_triangles) {
            add(0, 1, 2, 1), add(0, 2, 3, 1);
            add(1, 0, 3, 2), add(2, 1, 3, 2);
        } else {
            both.push_back(surface);
            both.push_back({surface.shape, -surface.normal, 2});
        }
    }
    return both;
}

TEST(StandingBodies, ExcludeFloatingTwoSidedShells) {
    for (const bool in_triangles : {false, true}) {
        for (const std::size_t sides : {6U, 5U}) {  // with and without the bottom, which is last
            std::vector<Surface> box = body({1, 1, 1}, {1, 2, 0.5}, 1);
            if (sides == 5) std::rotate(box.begin() + 4, box.begin() + 5, box.end()), box.resize(5);  // open above
            Scene floating = floor_with(shell(box, in_triangles));
            floating.faces.emplace_back("inside");
            EXPECT_FALSE(standing_bodies(floating, gap).any()) << sides << in_triangles;
            for (Surface& surface : floating.surfaces) {
                if (surface.face == 2) surface.face = 1;
            }
            EXPECT_FALSE(standing_bodies(floating, gap).any()) << sides << in_triangles << ", of one face";
        }
    }
}

TEST(StandingBodies, IncludeTwoSidedShells) {
    for (const bool in_triangles : {false, true}) {
        const Scene scene = [&] {
            Scene standing = floor_with(shell(body({1.5, 1, 0}, {1, 2, 0.5}, 1), in_triangles));
            standing.faces.emplace_back("inside");
            return standing;
        }();
        const auto found = standing_bodies(scene, gap);
        EXPECT_NEAR(area_left(scene, found, 0), 14, 1e-12);
        EXPECT_NEAR(area_left(scene, found, 1), 2 * (0.5 + 1) + 2, 1e-12);
        EXPECT_NEAR(area_left(scene, found, 2), 2 * (0.5 + 1) + 4, 1e-12) << "nothing of the inside";
    }
}

// The tiles beneath and behind the body are as large as its sides, which are thus their backs.
TEST(StandingBodies, StandOnTilesOfTheirSizeInACorner) {
    std::vector<Surface> box = body({0, 0, 0}, {1, 1, 1}, 2);
    Scene scene;
    scene.faces = {"floor", "walls", "body"};
    for (const int x : {0, 1}) {
        for (const int y : {0, 1}) scene.surfaces.push_back(side(Vector3d(x, y, 0), {1, 0, 0}, {0, 1, 0}, 0));
        scene.surfaces.push_back(side(Vector3d(x, 0, 0), {0, 0, 1}, {1, 0, 0}, 1));
        scene.surfaces.push_back(side(Vector3d(0, x, 0), {0, 1, 0}, {0, 0, 1}, 1));
    }
    scene.surfaces.insert(scene.surfaces.end(), box.begin(), box.end());
    const auto found = standing_bodies(scene, gap);
    EXPECT_NEAR(area_left(scene, found, 0), 3, 1e-12);
    EXPECT_NEAR(area_left(scene, found, 1), 2, 1e-12);
    EXPECT_NEAR(area_left(scene, found, 2), 3, 1e-12);
}

/// Floor, two walls and a ceiling of 4 x 4 that meet at (0, 0, 0), and some sides of a body: face 1, to which nothing
/// else belongs.
Scene in_a_corner(const std::vector<Surface>& body) {
    Scene scene;
    scene.faces = {"room", "body"};
    scene.surfaces = {side({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 0), side({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, 0),
                      side({0, 0, 0}, {0, 4, 0}, {0, 0, 4}, 0), side({0, 0, 4}, {0, 4, 0}, {4, 0, 0}, 0)};
    scene.surfaces.insert(scene.surfaces.end(), body.begin(), body.end());
    return scene;
}

/// A body without the sides of these numbers (see body()).
std::vector<Surface> without_sides(std::vector<Surface> all, const std::vector<std::size_t>& hidden) {
    for (auto each = hidden.rbegin(); each != hidden.rend(); ++each)
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(*each));
    return all;
}

TEST(StandingBodies, CoverWallsWhereTheirHiddenSidesAreMissing) {
    const auto left = [](const std::vector<Surface>& body) {
        const Scene scene = in_a_corner(body);
        const auto found = standing_bodies(scene, gap);
        EXPECT_NEAR(area_left(scene, found, 1), area_left(scene, {}, 1), 1e-12);
        return area_left(scene, found, 0);
    };
    const auto at_the_wall = body({1, 0, 0}, {1, 1, 2}, 1);
    EXPECT_NEAR(left(without_sides(at_the_wall, {0, 5})), 64 - 2 - 1, 1e-12);
    // With a bottom, which the floor then covers.
    const Scene scene = in_a_corner(without_sides(at_the_wall, {0}));
    EXPECT_NEAR(area_left(scene, standing_bodies(scene, gap), 0), 64 - 2 - 1, 1e-12);
    EXPECT_NEAR(area_left(scene, standing_bodies(scene, gap), 1), 2 + 2 + 2 + 1, 1e-12);
    const auto in_the_corner = body({0, 0, 0}, {1, 1.5, 2}, 1);
    EXPECT_NEAR(left(without_sides(in_the_corner, {0, 3, 5})), 64 - 2 - 3 - 1.5, 1e-12);
    const auto up_to_the_ceiling = body({1, 0, 0}, {1, 1, 4}, 1);
    EXPECT_NEAR(left(without_sides(up_to_the_ceiling, {0, 4, 5})), 64 - 4 - 2, 1e-12);
    const auto column = body({0, 0, 0}, {1, 1, 4}, 1);
    EXPECT_NEAR(left(without_sides(column, {0, 3, 4, 5})), 64 - 4 - 4 - 2, 1e-12);
}

TEST(StandingBodies, LeaveWallsAloneBehindOpenBodies) {
    const auto at_the_wall = body({1, 0, 0}, {1, 1, 2}, 1);
    EXPECT_FALSE(standing_bodies(in_a_corner(without_sides(at_the_wall, {0, 2, 5})), gap).any()) << "open in front";
    EXPECT_FALSE(standing_bodies(in_a_corner(without_sides(at_the_wall, {0, 4, 5})), gap).any()) << "open above";
    const auto hovering = body({1, 1e-9, 0}, {1, 1, 2}, 1);
    EXPECT_FALSE(standing_bodies(in_a_corner(without_sides(hovering, {0, 5})), gap).any()) << "behind is a gap";
    const auto too_high = body({1, 0, 0}, {1, 1, 5}, 1);
    EXPECT_FALSE(standing_bodies(in_a_corner(without_sides(too_high, {0, 5})), gap).any()) << "higher than the wall";
}

// The neighbor's side continues the plane of the body's own, beside the corner that both touch.
TEST(StandingBodies, CoverWallsBesideANeighborInLine) {
    auto two = without_sides(body({0, 0, 0}, {1, 2, 1}, 1), {0, 3, 5});
    for (const Surface& surface : body({1, 2, 0}, {1, 1, 2}, 1)) two.push_back(surface);
    const Scene scene = in_a_corner(two);
    EXPECT_NEAR(area_left(scene, standing_bodies(scene, gap), 0), 64 - 2 - 1 - 2 - 1, 1e-12);
}

TEST(StandingBodies, CoverTheSideOfAHigherNeighbor) {
    auto two = body({1, 1, 0}, {1, 1, 2}, 1);
    for (const Surface& surface : without_sides(body({2, 1, 0}, {1, 1, 1}, 1), {3, 5})) two.push_back(surface);
    const Scene scene = floor_with(two);
    const auto found = standing_bodies(scene, gap);
    EXPECT_NEAR(area_left(scene, found, 0), 14, 1e-12);
    EXPECT_NEAR(area_left(scene, found, 1), 8 + 1 - 1 + 3 + 1, 1e-12) << "less the side and its bottom";
}

// Without bottoms: a wall against a wall, an edge at an edge, and one body on another of the same size.
TEST(StandingBodies, TouchEachOther) {
    for (const Vector3d& at : {Vector3d(2, 1, 0), Vector3d(2, 2, 0), Vector3d(1, 1, 1)}) {
        for (const double depth : {1.0, 0.5}) {
            auto two = without_sides(body({1, 1, 0}, {1, 1, 1}, 1), {5});
            for (const Surface& surface : without_sides(body(at, {1, depth, 1}, 1), {5})) two.push_back(surface);
            const Scene scene = floor_with(two);
            const auto found = standing_bodies(scene, gap);
            const double on_floor = at.z() == 0 ? 1 + depth : 1;
            const double contact = at == Vector3d(2, 1, 0) ? 2 * depth : at.z() > 0 ? depth : 0;
            EXPECT_NEAR(area_left(scene, found, 0), 16 - on_floor, 1e-12) << at.transpose() << ", depth " << depth;
            EXPECT_NEAR(area_left(scene, found, 1), 5 + 2 + 3 * depth - contact, 1e-12) << at.transpose();
        }
    }
}

TEST(StandingBodies, ReachFromWallToWall) {
    Scene scene = in_a_corner(without_sides(body({0, 0, 0}, {4, 1, 1}, 1), {0, 1, 3, 5}));
    scene.surfaces.push_back(side({4, 0, 0}, {0, 0, 4}, {0, 4, 0}, 0));
    EXPECT_NEAR(area_left(scene, standing_bodies(scene, gap), 0), 80 - 4 - 4 - 2, 1e-12);
}

}  // namespace
}  // namespace ff

#include "core/geometry/joined_surfaces.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/touching.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// The same tile with its edges wound in another of the eight ways.
Parallelogram wound(const Parallelogram& tile, unsigned way) {
    auto [corner, u, v] = tile;
    if ((way & 1u) != 0) {
        corner += u;
        u = -u;
    }
    if ((way & 2u) != 0) {
        corner += v;
        v = -v;
    }
    if ((way & 4u) != 0) std::swap(u, v);
    return {corner, u, v};
}

/// A turned box of m x m tiles a wall, wound and ordered at random.
Scene tiled(const Scene& box, std::uint32_t m) {
    std::mt19937 random(1);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(0.3, 0.5, 0.8).normalized()).toRotationMatrix();
    Scene scene = box;
    scene.empty_box.reset();
    scene.surfaces.clear();
    for (const Surface& wall : box.surfaces) {
        for (std::uint32_t i = 0; i < m * m; ++i) {
            auto [corner, u, v] = patch(parallelogram(wall), {m, m}, i);
            scene.surfaces.push_back(
                {wound({turn * corner, turn * u, turn * v}, random() % 8), turn * wall.normal, wall.face});
        }
    }
    std::shuffle(scene.surfaces.begin(), scene.surfaces.end(), random);
    return scene;
}

/// Every parallelogram as two triangles.
Scene triangulated(const Scene& scene) {
    Scene result = scene;
    result.surfaces.clear();
    for (const Surface& surface : scene.surfaces) {
        const auto& [corner, u, v] = parallelogram(surface);
        result.surfaces.push_back({Triangle{corner, corner + u, corner + u + v}, surface.normal, surface.face});
        result.surfaces.push_back({Triangle{corner + u + v, corner + v, corner}, surface.normal, surface.face});
    }
    return result;
}

/// Whether the joined surfaces cover what the others do: the same area of every face, and places of theirs.
void expect_same_cover(const Scene& joined, const Scene& scene) {
    for (std::size_t face = 0; face < scene.faces.size(); ++face) {
        const double before = face_area(scene, static_cast<int>(face));
        EXPECT_NEAR(face_area(joined, static_cast<int>(face)), before, 1e-12 * before) << scene.faces[face];
    }
    for (const Surface& surface : scene.surfaces) {
        const SurfaceMap map(surface);
        for (const double s : {0.01, 0.6, 0.99}) {
            const Vector3d place = map.at(s, 0.3).position;
            EXPECT_EQ(1, std::count_if(joined.surfaces.begin(), joined.surfaces.end(), [&](const Surface& other) {
                          return other.face == surface.face && other.normal.isApprox(surface.normal, 1e-12) &&
                                 lies_on(place, other, 1e-12);
                      }));
        }
    }
}

TEST(JoinedSurfaces, RecoverTiledWalls) {
    for (const std::uint32_t m : {2u, 3u, 13u}) {
        const Scene scene = tiled(make_box(1, 2, 0.7), m);
        const Scene joined = join_level_surfaces(scene).scene;
        EXPECT_EQ(joined.surfaces.size(), 6u) << m;
        expect_same_cover(joined, scene);
    }
}

TEST(JoinedSurfaces, RecoverTheWallsOfAMesh) {
    const Scene scene = triangulated(tiled(make_box(1, 2, 0.7), 8));
    const Scene joined = join_level_surfaces(scene).scene;
    EXPECT_EQ(joined.surfaces.size(), 6u);
    expect_same_cover(joined, scene);
}

TEST(JoinedSurfaces, StaySeparateAcrossFacesAndSides) {
    Scene scene;
    scene.faces = {"a", "b"};
    const auto add = [&](double x, int face, double side) {
        scene.surfaces.push_back(
            {Parallelogram{{x, 0, 0}, Vector3d::UnitX(), Vector3d::UnitY()}, side * Vector3d::UnitZ(), face});
    };
    add(0, 0, 1);
    add(1, 1, 1);    // of another face
    add(-1, 0, -1);  // looks the other way
    EXPECT_EQ(join_level_surfaces(scene).scene.surfaces.size(), 3u);
    add(1, 0, 1);  // and this one continues the first
    EXPECT_EQ(join_level_surfaces(scene).scene.surfaces.size(), 3u);
}

TEST(JoinedSurfaces, ExcludeOverlappingSurfaces) {
    Scene scene;
    scene.faces = {"a"};
    for (const double length : {1.0, 2.0}) {
        scene.surfaces.push_back(
            {Parallelogram{{0, 0, 0}, length * Vector3d::UnitX(), Vector3d::UnitY()}, Vector3d::UnitZ(), 0});
    }
    EXPECT_EQ(join_level_surfaces(scene).scene.surfaces.size(), 2u);
}

TEST(JoinedSurfaces, DivideAnLShapeIntoTwo) {
    Scene scene;
    scene.faces = {"a"};
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}}) {
        scene.surfaces.push_back(
            {Parallelogram{Vector3d(x, y, 0), Vector3d::UnitX(), Vector3d::UnitY()}, Vector3d::UnitZ(), 0});
    }
    const Scene joined = join_level_surfaces(scene).scene;
    EXPECT_EQ(joined.surfaces.size(), 2u);
    expect_same_cover(joined, scene);
}

}  // namespace
}  // namespace ff

// A ray that starts on the rounded edge of a tile must not be caught by the back of the tile beside it. In these two
// tests, 16 and 11 rays were caught before Embree's tracer allowed for it.

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <vector>

namespace ff {
namespace {

/// The box with every wall made of m x m surfaces, turned such that no coordinate of a wall is a round number.
Scene turned_mosaic(const Scene& box, std::uint32_t m) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.3, 0.5, std::sqrt(0.66))).toRotationMatrix();
    Scene scene = box;
    scene.empty_box.reset();
    scene.surfaces.clear();
    for (const Surface& wall : box.surfaces) {
        for (std::uint32_t i = 0; i < m * m; ++i) {
            const Parallelogram tile = patch(parallelogram(wall), {m, m}, i);
            scene.surfaces.push_back({Parallelogram{turn * tile.corner, turn * tile.edge_u, turn * tile.edge_v},
                                      turn * wall.normal, wall.face});
        }
    }
    return scene;
}

/// Turns a room into a block: its walls are seen from outside.
Scene inside_out(Scene scene) {
    for (Surface& surface : scene.surfaces) {
        std::swap(parallelogram(surface).edge_u, parallelogram(surface).edge_v);
        surface.normal = -surface.normal;
    }
    return scene;
}

struct RayEnds {
    std::uint64_t received = 0;
    std::uint64_t from_behind = 0;
    std::uint64_t nowhere = 0;
};

RayEnds shoot_from_every_surface(const Scene& scene) {
    const auto tracer = make_embree_tracer(scene);
    RayBatch rays;
    std::vector<Hit> hits(block_capacity);
    RayEnds ends;
    for (std::uint32_t source = 0; source < scene.surfaces.size(); ++source) {
        generate_rays(scene.surfaces[source], source, undivided, 0, *test::random_block(source, block_capacity), rays);
        tracer->trace(rays, hits);
        for (const Hit& hit : hits)
            ++(hit.surface == no_surface ? ends.nowhere : hit.received ? ends.received : ends.from_behind);
    }
    return ends;
}

TEST(LevelNeighbours, DoNotCatchRaysInARoom) {
    const RayEnds ends = shoot_from_every_surface(turned_mosaic(make_box(1, 1, 1), 40));
    EXPECT_EQ(ends.received, std::uint64_t{6} * 40 * 40 * block_capacity);
    EXPECT_EQ(ends.from_behind, 0u);
    EXPECT_EQ(ends.nowhere, 0u);
}

// Nothing outside a block receives its rays: they all leave, past the neighbours across its edges.
TEST(LevelNeighbours, DoNotCatchRaysFromABlock) {
    Scene block = inside_out(turned_mosaic(make_box(1, 1, 1), 40));
    block.closed = false;
    const RayEnds ends = shoot_from_every_surface(block);
    EXPECT_EQ(ends.nowhere, std::uint64_t{6} * 40 * 40 * block_capacity);
}

// Checks the check: a tile that hangs just in front of another, back to back, does catch rays.
TEST(LevelNeighbours, CheckNoticesATileInFront) {
    Scene room = turned_mosaic(make_box(1, 1, 1), 4);
    Surface tile = room.surfaces[5];
    parallelogram(tile).corner += 1e-5 * tile.normal;
    room.surfaces.push_back(tile);
    EXPECT_GT(shoot_from_every_surface(room).from_behind, block_capacity / 2);
}

}  // namespace
}  // namespace ff

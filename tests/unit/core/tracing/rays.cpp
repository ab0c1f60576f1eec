#include "core/tracing/rays.hpp"

#include "core/geometry/box.hpp"
#include "core/support/error.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace ff {
namespace {

/// A skew parallelogram that lies along no axis.
Surface tilted_surface() {
    Surface surface{Parallelogram{{0.3, -1, 2}, {1, 2, 0.5}, {-0.4, 0.7, 1.1}}, {}, 0};
    surface.normal = parallelogram(surface).edge_u.cross(parallelogram(surface).edge_v).normalized();
    return surface;
}

/// The value that a coordinate stands for: its upper 24 bits, made odd.
double value(std::uint32_t word) {
    return ((word >> 8) | 1u) * 0x1p-24;
}

Eigen::Vector3d direction(const RayBatch& rays, std::size_t i) {
    return {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]};
}

Eigen::Vector3d origin(const RayBatch& rays, std::size_t i) {
    return {rays.origin_x[i], rays.origin_y[i], rays.origin_z[i]};
}

TEST(Rays, FollowMalleysMethodToSinglePrecision) {
    const Surface surface = tilted_surface();
    const auto block = test::random_block(1);
    RayBatch rays;
    generate_rays(surface, 0, undivided, 0, *block, rays);
    const Eigen::Vector3d tangent = parallelogram(surface).edge_u.normalized();
    const Eigen::Vector3d bitangent = surface.normal.cross(tangent);
    ASSERT_EQ(rays.size(), block->size);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double x = value(block->coordinate[2][i]);
        const double angle = 2 * std::numbers::pi * value(block->coordinate[3][i]);
        const Eigen::Vector3d expected = std::sqrt(x) * std::cos(angle) * tangent +
                                         std::sqrt(x) * std::sin(angle) * bitangent + std::sqrt(1 - x) * surface.normal;
        // A dozen roundings of 2^-25 and the polynomials' 1.4e-7.
        EXPECT_LT((direction(rays, i).normalized() - expected).norm(), 5e-7) << i;
    }
}

TEST(Rays, StartAtTheSurfacePointsOfThePatch) {
    const Surface surface = tilted_surface();
    const auto block = test::random_block(2);
    constexpr Grid grid{13, 13};
    const std::uint32_t index = 4 * 13 + 9;  // row 4, column 9
    RayBatch rays;
    generate_rays(surface, 3, grid, index, *block, rays);
    EXPECT_EQ(rays.source, 3u);
    const Parallelogram shape = patch(parallelogram(surface), grid, index);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Eigen::Vector3d expected = shape.corner + value(block->coordinate[0][i]) * shape.edge_u +
                                         value(block->coordinate[1][i]) * shape.edge_v;
        EXPECT_LT((origin(rays, i) - expected).norm(), 1e-6) << i;
    }
}

TEST(Rays, AreWellDefinedAtTheExtremesOfEveryCoordinate) {
    auto block = std::make_unique<PointBlock>();
    const std::array<std::uint32_t, 8> words{0,          0xff,       0x3fffffff, 0x40000000,
                                             0x7fffffff, 0x80000000, 0xffffff00, 0xffffffff};
    for (const std::uint32_t x : words) {
        for (const std::uint32_t y : words) {
            for (std::size_t d = 0; d < 4; ++d) block->coordinate[d][block->size] = d % 2 == 0 ? x : y;
            ++block->size;
        }
    }
    const Scene box = make_box(6, 6, 6);
    RayBatch rays;
    for (std::uint32_t s = 0; s < 6; ++s) {
        generate_rays(box.surfaces[s], s, {13, 13}, 168, *block, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            EXPECT_TRUE(direction(rays, i).allFinite());
            EXPECT_GT(direction(rays, i).dot(box.surfaces[s].normal), 0);
            EXPECT_GE(origin(rays, i).minCoeff(), 0);
            EXPECT_LE(origin(rays, i).maxCoeff(), 6);
            EXPECT_EQ(origin(rays, i).dot(box.surfaces[s].normal),
                      parallelogram(box.surfaces[s]).corner.dot(box.surfaces[s].normal));
        }
    }
}

TEST(Rays, NeverStartOutsideTheSurfaceWhateverTheSubdivision) {
    const Surface unit{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0};
    PointBlock block;
    block.size = 1;
    for (auto& row : block.coordinate) row[0] = 0xffffffff;
    RayBatch rays;
    for (std::uint32_t m = 1; m <= 3000; ++m) {
        const std::uint32_t n = 3001 - m;
        generate_rays(unit, 0, {m, n}, m * n - 1, block, rays);
        ASSERT_LE(rays.origin_x[0], 1) << m;
        ASSERT_LE(rays.origin_y[0], 1) << m;
        ASSERT_GT(rays.origin_x[0], 1 - 1.0f / static_cast<float>(m)) << m;
        ASSERT_GT(rays.origin_y[0], 1 - 1.0f / static_cast<float>(n)) << m;
    }
}

TEST(Rays, HaveTheSameBitsWithEveryInstructionSet) {
    const Surface surface = tilted_surface();
    const auto results = test::with_each_instruction_set([&surface] {
        std::vector<float> all;
        RayBatch rays;
        for (std::uint32_t number = 0; number < 100; ++number) {
            generate_rays(surface, 0, {13, 13}, number, *test::random_block(number, 1000), rays);
            for (const auto* component : {&rays.origin_x, &rays.origin_y, &rays.origin_z, &rays.direction_x,
                                          &rays.direction_y, &rays.direction_z}) {
                all.insert(all.end(), component->begin(), component->end());
            }
        }
        return all;
    });
    for (const auto& result : results) EXPECT_EQ(result, results.front());
}

TEST(Rays, RefuseLengthsBeyondSinglePrecision) {
    Surface surface = tilted_surface();
    parallelogram(surface).edge_u *= 1e300;
    EXPECT_THROW(surface_frame(surface), UserError);
}

}  // namespace
}  // namespace ff

// Estimators in scenes whose surfaces have grids of their own.

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/estimators/points/point_to_polygon.hpp"
#include "core/estimators/rays/ray_shooting.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/patches/face_averages.hpp"
#include "core/patches/patch_order.hpp"
#include "tests/support/gauss_points.hpp"
#include "tests/support/gridded_rooms.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/support/round_scenes.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ff {
namespace {

constexpr StreamKey grid_key{3, 4};

// For every shape, rays start in their patch's cell of the map, to single precision; azimuths wrap around.
TEST(Grids, StartRaysOnTheirPatch) {
    std::vector<Surface> surfaces = test::closed_can().surfaces;
    surfaces.push_back(test::gridded_room().surfaces[0]);
    surfaces.push_back({Triangle{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0});
    surfaces.push_back(test::sphere(test::somewhere, 1.5, Facing::outward));
    constexpr Grid grid{2, 12};
    for (const Surface& surface : surfaces) {
        const SurfaceMap map(surface);
        for (std::uint32_t patch = 0; patch < grid.parts(); ++patch) {
            RayBatch rays;
            generate_rays(surface, 0, grid, patch, *test::random_block(patch, 200), rays);
            double least_s = 1, most_s = 0, least_t = 1, most_t = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const auto [s, t] = map.coordinates({rays.origin_x[i], rays.origin_y[i], rays.origin_z[i]});
                least_s = std::min(least_s, s);
                most_s = std::max(most_s, s);
                least_t = std::min(least_t, t);
                most_t = std::max(most_t, t);
            }
            const double column = patch % 2 / 2.0;
            const double row = (patch - patch % 2) / 24.0;
            EXPECT_GT(least_s, column - 1e-6) << patch;
            EXPECT_LT(most_s, column + 1.0 / 2 + 1e-6) << patch;
            EXPECT_GT(least_t, row - 1e-6) << patch;
            EXPECT_LT(most_t, row + 1.0 / 12 + 1e-6) << patch;
            // 200 uniform numbers leave 8 % of either end free with probability 6e-8.
            EXPECT_GT(most_s - least_s, 0.84 / 2) << patch;
            EXPECT_GT(most_t - least_t, 0.84 / 12) << patch;
        }
    }
}

RayTally tally_of_trial(const Scene& scene, std::uint32_t m, std::uint64_t samples, Allocation allocation,
                        std::uint32_t trial, PatchSums* sums) {
    RayTally tally;
    const std::uint64_t points = allocation == Allocation::face ? samples * m * m : samples;
    ray_shooting(scene, {m}, *make_tracer(scene, TracerChoice::automatic), test::PhiloxPoints(points), samples,
                 allocation, grid_key, trial, tally, sums);
    return tally;
}

TEST(Grids, ShootEquallyManyRaysFromEveryPatch) {
    const Scene room = test::gridded_room();
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        PatchSums sums;
        const RayTally tally = tally_of_trial(room, 2, 1500, allocation, 0, &sums);
        for (std::size_t face = 0; face < 6; ++face) {
            EXPECT_EQ(tally.rays[face], 4u * 1500 * room.surfaces[face].grid.parts());
            const auto row = tally.hits.begin() + static_cast<std::ptrdiff_t>(6 * face);
            EXPECT_EQ(std::accumulate(row, row + 6, std::uint64_t{0}), tally.rays[face]);
        }
        ASSERT_EQ(sums.hits.size(), 80u * 6);
        for (auto row = sums.hits.begin(); row != sums.hits.end(); row += 6)
            EXPECT_EQ(std::accumulate(row, row + 6, std::uint64_t{0}), 1500u);
    }
}

// Each of 80 patches and its most likely face, with both allocations: 160 exact binomial tests of 1e-7. Rows and
// columns confused, or patches of another surface, would change these factors by 0.05 and more.
TEST(Grids, AreUnbiasedUnderRayShooting) {
    const Scene room = test::gridded_room();
    const Eigen::MatrixXd exact = exact_patch_to_face(room, {2}).value();
    constexpr std::uint64_t rays = 20000;
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        PatchSums sums;
        tally_of_trial(room, 2, rays, allocation, 0, &sums);
        for (Eigen::Index patch = 0; patch < 80; ++patch) {
            Eigen::Index to = 0;
            exact.row(patch).maxCoeff(&to);
            const std::uint64_t hits = sums.hits[static_cast<std::size_t>(patch * 6 + to)];
            EXPECT_TRUE(test::has_probability(hits, rays, exact(patch, to), {.alpha = 1e-7, .detects = 0.04})) << patch;
        }
    }
}

// 300 trials, and a t test at 1e-6 of every pair from a face of two surfaces. Weighing them by hits in place of areas
// would give the smaller one 2/5 of the face, where it has 1/4: factors wrong by up to 0.03.
TEST(Grids, WeighTheSurfacesOfAFaceByArea) {
    const Scene room = test::room_with_divided_floor();
    const Eigen::MatrixXd exact = exact_form_factors(room).value();
    std::vector<std::vector<double>> estimates(6);
    double by_hits = 0;
    for (std::uint32_t trial = 0; trial < 300; ++trial) {
        const RayTally tally = tally_of_trial(room, 1, 200, Allocation::patch, trial, nullptr);
        EXPECT_EQ(tally.rays[0], 200u * 5);
        const Eigen::MatrixXd factors = face_averages(room, tally.weighted, 200);
        EXPECT_NEAR(factors.row(0).sum(), 1, 1e-14);
        for (std::size_t to = 1; to < 6; ++to) estimates[to].push_back(factors(0, static_cast<Eigen::Index>(to)));
        by_hits += static_cast<double>(tally.hits[3]) / 1000 / 300;
    }
    for (std::size_t to = 1; to < 6; ++to) {
        EXPECT_TRUE(test::unbiased(estimates[to], exact(0, static_cast<Eigen::Index>(to)), {.detects = 0.008})) << to;
    }
    EXPECT_GT(by_hits - exact(0, 3), 0.015) << "the mistake that this would notice";
}

// Opposite faces have smooth kernels. Edges of patches are at most a quarter as long as their distance, so that the
// error of n nodes along an edge falls as 16^-2n and faster: 6 leave 1e-14 of it. What 12 nodes leave of points is the
// jump at corners.
TEST(Grids, DoNotReduceTheAccuracyOfKernelsAndPoints) {
    for (const Scene& room : {test::gridded_room(), test::room_with_divided_floor()}) {
        const Eigen::MatrixXd exact = exact_form_factors(room).value();
        const Eigen::MatrixXd exact_patches = exact_patch_to_face(room, {2}).value();
        const PatchOrder order(room, {2});
        for (const bool symmetric : {true, false}) {
            test::GaussPoints points(6, 6);
            if (!symmetric) points.deny_exchangeable();
            PatchFactorSums sums;
            const Eigen::MatrixXd kernel = area_kernel(room, {2}, points, PointMap::uniform, grid_key, 0, &sums);
            EXPECT_NEAR(kernel(0, 5), exact(0, 5), 1e-10);
            EXPECT_NEAR(kernel(5, 0), exact(5, 0), 1e-10);
            for (std::uint32_t p = 0; p < order.count(0); ++p)
                EXPECT_NEAR(sums.factors[std::size_t{p} * 6 + 5], exact_patches(p, 5), 1e-10) << p;
        }
        const auto points = [&](std::uint32_t m, int nodes) {
            const test::GaussPoints rule(nodes, 1);
            return point_to_polygon(room, {m}, rule, rule.points(), Allocation::patch, grid_key, 0);
        };
        const Eigen::MatrixXd fine = points(4, 12);
        EXPECT_NEAR(fine(0, 5), exact(0, 5), 1e-13);
        EXPECT_NEAR(fine(5, 0), exact(5, 0), 1e-13);
        EXPECT_LT((fine - exact).cwiseAbs().maxCoeff(), (points(1, 6) - exact).cwiseAbs().maxCoeff() / 16);
    }
}

// 200 trials, a t test at 1e-6 of 30 pairs with either allocation.
TEST(Grids, AreUnbiasedForRandomPoints) {
    const Scene room = test::gridded_room();
    const Eigen::MatrixXd exact = exact_form_factors(room).value();
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        const std::uint64_t points = allocation == Allocation::face ? 4 * 16 : 16;
        std::vector<std::vector<double>> estimates(36);
        for (std::uint32_t trial = 0; trial < 200; ++trial) {
            const Eigen::MatrixXd found =
                point_to_polygon(room, {2}, test::PhiloxPoints(points), 16, allocation, grid_key, trial);
            for (std::size_t k = 0; k < 36; ++k)
                estimates[k].push_back(found(static_cast<Eigen::Index>(k / 6), static_cast<Eigen::Index>(k % 6)));
        }
        for (std::size_t k = 0; k < 36; ++k) {
            if (k % 7 == 0) continue;
            const double truth = exact(static_cast<Eigen::Index>(k / 6), static_cast<Eigen::Index>(k % 6));
            EXPECT_TRUE(test::unbiased(estimates[k], truth, {.detects = 0.01})) << k;
        }
    }
}

}  // namespace
}  // namespace ff

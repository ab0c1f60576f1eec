#include "core/radiosity/patch_factors.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/patches/patch_order.hpp"
#include "core/radiosity/solver.hpp"
#include "core/radiosity/system.hpp"
#include "tests/support/gridded_rooms.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff {
namespace {

constexpr Subdivision three_by_three{3};
constexpr StreamKey patch_factor_key{1, 2};

Eigen::MatrixXd shot(const Scene& scene, std::uint64_t rays, Allocation allocation = Allocation::patch) {
    return shoot_patch_factors(scene, three_by_three, *make_tracer(scene, TracerChoice::automatic),
                               test::PhiloxPoints(rays), rays, allocation, patch_factor_key, 5);
}

TEST(ExactPatchFactors, AddUpToPatchToFaceFactors) {
    for (const char* name : {"cube", "box:2x1x0.5"}) {
        const Scene scene = built_in_scene(name);
        const Eigen::MatrixXd factors = exact_patch_factors(scene, three_by_three).value();
        const Eigen::MatrixXd to_faces = exact_patch_to_face(scene, three_by_three).value();
        for (int face = 0; face < 6; ++face) {
            const Eigen::VectorXd sums = factors.middleCols(Eigen::Index{9} * face, 9).rowwise().sum();
            // 1e-15 of the squared extent, over the area of a patch, nine times.
            EXPECT_LT((sums - to_faces.col(face)).cwiseAbs().maxCoeff(), 1e-12);
        }
        const FactorProperties properties = factor_properties(factors, patch_areas(scene, three_by_three));
        EXPECT_LT(properties.closure_defect, 1e-11);
        EXPECT_LT(properties.reciprocity_defect, 1e-15);
    }
}

TEST(ShotPatchFactors, AreTheRaysOfTheTrial) {
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        const Scene scene = built_in_scene("box:2x1x0.5");
        const std::uint64_t rays = 1500;  // more than a block
        RayTally tally;
        PatchSums sums;
        ray_shooting(scene, three_by_three, *make_tracer(scene, TracerChoice::automatic), test::PhiloxPoints(rays),
                     rays, allocation, patch_factor_key, 5, tally, &sums);
        const Eigen::MatrixXd factors = shot(scene, rays, allocation);
        for (int patch = 0; patch < 54; ++patch) {
            EXPECT_NEAR(factors.row(patch).sum(), 1, 1e-14);
            for (int face = 0; face < 6; ++face) {
                const double hits =
                    factors.row(patch).segment(Eigen::Index{9} * face, 9).sum() * static_cast<double>(rays);
                EXPECT_EQ(std::llround(hits),
                          static_cast<long long>(sums.hits[static_cast<std::size_t>(patch * 6 + face)]));
            }
        }
    }
}

// Each of 54 patches and its most likely target: 54 exact binomial tests of 1e-7 each. Rows and columns of the grid
// swapped, or counted from the other end, would change these factors by 0.02 and more.
TEST(ShotPatchFactors, AreUnbiased) {
    const Scene scene = built_in_scene("box:2x1x0.5");
    const Eigen::MatrixXd exact = exact_patch_factors(scene, three_by_three).value();
    const std::uint64_t rays = 20000;
    const Eigen::MatrixXd factors = shot(scene, rays);
    for (Eigen::Index patch = 0; patch < 54; ++patch) {
        Eigen::Index to = 0;
        exact.row(patch).maxCoeff(&to);
        const auto hits = static_cast<std::uint64_t>(std::llround(factors(patch, to) * static_cast<double>(rays)));
        EXPECT_TRUE(test::has_probability(hits, rays, exact(patch, to), {.alpha = 1e-7, .detects = 0.04})) << patch;
    }
}

// The same sums once more: random points use the streams of their pair of patches, other points serve all pairs.
TEST(KernelPatchFactors, AddUpToTheTrial) {
    const Scene scene = built_in_scene("box:2x1x0.5");
    for (const PointMap map : {PointMap::uniform, PointMap::graded}) {
        const test::PhiloxPoints points(40);
        PatchFactorSums sums;
        const Eigen::MatrixXd faces = area_kernel(scene, three_by_three, points, map, patch_factor_key, 5, &sums);
        const Eigen::MatrixXd factors = kernel_patch_factors(scene, three_by_three, points, map, patch_factor_key, 5);
        EXPECT_EQ(factors.diagonal(), Eigen::VectorXd::Zero(54));
        for (int patch = 0; patch < 54; ++patch) {
            for (int face = 0; face < 6; ++face) {
                EXPECT_NEAR(factors.row(patch).segment(Eigen::Index{9} * face, 9).sum(),
                            sums.factors[static_cast<std::size_t>(patch * 6 + face)], 1e-13);
            }
        }
        EXPECT_NEAR(factors.block(0, 45, 9, 9).sum() / 9, faces(0, 5), 1e-13);
    }
}

TEST(PatchSight, MatchesWhereExactFactorsArePositive) {
    for (const char* name : {"cube", "box:2x1x0.5"}) {
        const Scene scene = built_in_scene(name);
        const Eigen::MatrixXd factors = exact_patch_factors(scene, three_by_three).value();
        EXPECT_TRUE((patch_sight(scene, three_by_three) == (factors.array() > 0)).all());
    }
}

TEST(PatchAreas, AddUpToTheScene) {
    const Eigen::VectorXd areas = patch_areas(built_in_scene("box:2x1x0.5"), three_by_three);
    EXPECT_NEAR(areas.sum(), 2 * (2 * 1 + 2 * 0.5 + 1 * 0.5), 1e-14);
    EXPECT_NEAR(areas[0], 2.0 / 9, 1e-15);
    EXPECT_NEAR(areas[53], 2.0 / 9, 1e-15);
    EXPECT_NEAR(areas[9], 1.0 / 9, 1e-15);
}

/// Rooms whose surfaces have grids, one with two surfaces in a face.
const std::array<Scene, 2>& gridded() {
    static const std::array<Scene, 2> rooms{test::gridded_room(), test::room_with_divided_floor()};
    return rooms;
}

/// Factors from patches to patches, added up to faces.
Eigen::MatrixXd to_faces(const Eigen::MatrixXd& factors, const Scene& scene, Subdivision subdivision) {
    const PatchOrder order(scene, subdivision, Numbered::of_faces);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(factors.rows(), static_cast<Eigen::Index>(scene.faces.size()));
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
        sums.col(scene.surfaces[i].face) += factors.middleCols(order.first(i), order.count(i)).rowwise().sum();
    return sums;
}

TEST(PatchFactorsOfGrids, AddUpToFaceFactors) {
    for (const Scene& room : gridded()) {
        const Eigen::MatrixXd factors = exact_patch_factors(room, {2}).value();
        EXPECT_LT((to_faces(factors, room, {2}) - exact_patch_to_face(room, {2}).value()).cwiseAbs().maxCoeff(), 1e-12);
        const Eigen::VectorXd areas = patch_areas(room, {2});
        EXPECT_NEAR(areas.sum(), 2 * (4 * 1 + 4 * 2 + 1 * 2), 1e-13);
        const FactorProperties properties = factor_properties(factors, areas);
        EXPECT_LT(properties.closure_defect, 1e-11);
        EXPECT_LT(properties.reciprocity_defect, 1e-15);
        EXPECT_TRUE((patch_sight(room, {2}) == (factors.array() > 0)).all());
    }
}

// Every patch emits what it absorbs: all of them are as bright as one that absorbs all.
TEST(PatchFactorsOfGrids, GiveAFurnaceTheSameLightEverywhere) {
    for (const Scene& room : gridded()) {
        const Eigen::MatrixXd factors = exact_patch_factors(room, {2}).value();
        const Eigen::VectorXd half = Eigen::VectorXd::Constant(factors.rows(), 0.5);
        const auto exitance = solve_exactly({factors, patch_areas(room, {2}), half, half});
        ASSERT_TRUE(exitance);
        EXPECT_LT((exitance->array() - 1).abs().maxCoeff(), 1e-11);
    }
}

// As above, of each of 80 patches and the patch that it hits most. Rows and columns confused, or the grid of another
// surface, would change these factors by a quarter and more.
TEST(PatchFactorsOfGrids, AreUnbiasedUnderRayShooting) {
    const Scene& room = gridded()[0];
    const Eigen::MatrixXd exact = exact_patch_factors(room, {2}).value();
    const std::uint64_t rays = 20000;
    const Eigen::MatrixXd factors =
        shoot_patch_factors(room, {2}, *make_tracer(room, TracerChoice::automatic), test::PhiloxPoints(rays), rays,
                            Allocation::patch, patch_factor_key, 5);
    for (Eigen::Index patch = 0; patch < exact.rows(); ++patch) {
        Eigen::Index to = 0;
        exact.row(patch).maxCoeff(&to);
        const auto hits = static_cast<std::uint64_t>(std::llround(factors(patch, to) * static_cast<double>(rays)));
        EXPECT_TRUE(test::has_probability(hits, rays, exact(patch, to), {.alpha = 1e-7, .detects = 0.04})) << patch;
    }
}

TEST(PatchFactorsOfGrids, AreTheSumsOfTheTrial) {
    for (const Scene& room : gridded()) {
        RayTally tally;
        PatchSums hits;
        const auto tracer = make_tracer(room, TracerChoice::automatic);
        ray_shooting(room, {2}, *tracer, test::PhiloxPoints(400), 100, Allocation::face, patch_factor_key, 5, tally,
                     &hits);
        const Eigen::MatrixXd shot = to_faces(shoot_patch_factors(room, {2}, *tracer, test::PhiloxPoints(400), 100,
                                                                  Allocation::face, patch_factor_key, 5),
                                              room, {2});
        PatchFactorSums sums;
        area_kernel(room, {2}, test::PhiloxPoints(20), PointMap::graded, patch_factor_key, 5, &sums);
        const Eigen::MatrixXd kernels = to_faces(
            kernel_patch_factors(room, {2}, test::PhiloxPoints(20), PointMap::graded, patch_factor_key, 5), room, {2});
        for (Eigen::Index patch = 0; patch < shot.rows(); ++patch) {
            for (Eigen::Index face = 0; face < 6; ++face) {
                const std::size_t at = static_cast<std::size_t>(patch * 6 + face);
                EXPECT_EQ(std::llround(shot(patch, face) * 100), static_cast<long long>(hits.hits[at]));
                EXPECT_NEAR(kernels(patch, face), sums.factors[at], 1e-13);
            }
        }
    }
}

}  // namespace
}  // namespace ff

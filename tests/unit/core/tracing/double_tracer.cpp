// Scenes that single precision does not resolve are traced in double precision.

#include "core/geometry/box.hpp"
#include "core/geometry/placement.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/support/round_scenes.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t blocks_per_surface = 64;

/// Hits by face of 65536 rays from a surface, and the lost ones.
FaceHits hits_of(const Tracer& tracer, const Scene& scene, std::uint32_t source) {
    FaceHits hits(scene.faces.size() + 1);
    for (std::uint32_t number = 0; number < blocks_per_surface; ++number)
        tracer.shoot(source, undivided, 0, *test::random_block(number, block_capacity), hits);
    return hits;
}

/// Opposite discs of radius 1 at distance 1 with an opaque sheet, 0.8 in radius, this far above the lower one.
Scene disc_under_a_sheet(double gap, const Vector3d& by = Vector3d::Zero()) {
    const Vector3d up = test::tilted;
    Scene scene = test::faces_of({test::disc(by, up, 1), test::disc(by + up, -up, 1)}, false);
    scene.surfaces.push_back(test::disc(by + gap * up, up, 0.8));
    scene.surfaces.back().face = no_face;
    return scene;
}

/// Form factor from a disc of radius a to a coaxial disc of radius b, at distance 1. @see [howell] C-41
double opposite_discs(double a, double b) {
    const double x = 1 + (1 + b * b) / (a * a);
    return (x - std::sqrt(x * x - 4 * b * b / (a * a))) / 2;
}

// All rays from the upper disc that would end beneath the sheet end on it: F12 - F(disc to 0.8 disc).
TEST(DoubleTracer, LetsNoRayThroughASheetHoweverClose) {
    const double expected = opposite_discs(1, 1) - opposite_discs(1, 0.8);
    const double rays = blocks_per_surface * block_capacity;
    // Five standard errors: by chance in 6e-7 of runs; a transparent sheet is 140 of them away.
    const double room = 5 * std::sqrt(expected * (1 - expected) / rays);
    for (const double gap : {1e-3, 4e-7, 1e-9, 1e-11}) {
        for (const Vector3d& by : {Vector3d(0, 0, 0), Vector3d(1e4, 2e4, 0)}) {
            if (by.norm() * 1e-15 > gap) continue;
            const Scene scene = placed(disc_under_a_sheet(gap, by));
            const auto tracer = make_tracer(scene, TracerChoice::automatic);
            for (const std::uint32_t source : {0u, 1u}) {
                const double found = static_cast<double>(hits_of(*tracer, scene, source)[1 - source]) / rays;
                EXPECT_NEAR(found, expected, room) << "gap " << gap << " source " << source;
            }
        }
    }
}

// Checks the check: Embree's rays, which start a little off the disc, pass through the sheet.
TEST(DoubleTracer, IsNeededBecauseEmbreeMissesNearSheets) {
    const Scene scene = disc_under_a_sheet(4e-8);
    EXPECT_TRUE(has_fine_detail(scene));
    EXPECT_GT(hits_of(*make_embree_tracer(scene), scene, 0)[1], blocks_per_surface * block_capacity / 5);
}

TEST(DoubleTracer, AgreesWithEmbreeWhereThatResolvesTheScene) {
    for (const Scene& scene : {test::closed_can(), test::closed_cone(), test::concentric_spheres(),
                               test::hollow_sphere(), test::domed_frustum(), make_box(3, 2, 1)}) {
        const auto embree = make_embree_tracer(scene);
        const auto precise = make_double_tracer(scene);
        std::vector<Hit> a(block_capacity);
        std::vector<Hit> b(block_capacity);
        std::size_t differ = 0;
        std::size_t rays = 0;
        for (std::uint32_t source = 0; source < scene.surfaces.size(); ++source) {
            for (std::uint32_t number = 0; number < 16; ++number) {
                const auto block = test::random_block(number, block_capacity);
                embree->find_ends(scene.surfaces[source], source, undivided, 0, *block, a);
                precise->find_ends(scene.surfaces[source], source, undivided, 0, *block, b);
                for (std::size_t i = 0; i < a.size(); ++i) {
                    differ += a[i].surface != b[i].surface || a[i].received != b[i].received;
                    EXPECT_NE(b[i].surface, no_surface);
                }
                rays += a.size();
            }
        }
        EXPECT_LE(differ, rays / 10000);
    }
}

TEST(FineDetail, IsAbsentWhereSurfacesOnlyShareEdges) {
    Scene box = make_box(3, 2, 1);
    box.empty_box.reset();
    EXPECT_FALSE(has_fine_detail(box));
    for (const Scene& scene : {test::closed_can(), test::closed_cone(), test::concentric_spheres()})
        EXPECT_FALSE(has_fine_detail(scene));
}

TEST(FineDetail, IsFoundWhereSurfacesNearlyTouch) {
    EXPECT_TRUE(has_fine_detail(disc_under_a_sheet(4e-7)));
    EXPECT_FALSE(has_fine_detail(disc_under_a_sheet(0.1)));
    const Surface floor{Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 1}, 0};
    EXPECT_TRUE(has_fine_detail(test::faces_of({floor, test::sphere({0, 0, 0.5}, 0.5, Facing::outward)}, false)))
        << "a ball on the floor";
    EXPECT_TRUE(has_fine_detail(
        test::faces_of({floor, test::wall({-0.9, 0, 0.3}, {1.8, 0, 0}, 0.3, 0.3, Facing::outward)}, false)))
        << "a cylinder on its side";
    const Vector3d up(0, 0, 1);
    EXPECT_TRUE(has_fine_detail(test::faces_of({test::wall({0, 0, 0}, up, 1, 1, Facing::inward),
                                                test::wall({0, 0, 0}, up, 1 - 1e-7, 1 - 1e-7, Facing::outward)},
                                               false)))
        << "a narrow annulus";
    EXPECT_TRUE(has_fine_detail(
        test::faces_of({floor, {Parallelogram{{0, 0, 0.5}, {1e-4, 0, 0}, {0, 1e-4, 0}}, {0, 0, -1}, 0}}, false)))
        << "a small face";
}

}  // namespace
}  // namespace ff

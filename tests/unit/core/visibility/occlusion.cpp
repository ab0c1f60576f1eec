#include "core/visibility/occlusion.hpp"

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/radiosity/enclosures.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/support/gauss_points.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface square(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), 0};
}

/// Unit squares at distance 1 that face each other, and a square of half the edge in the middle between them.
Scene squares_with_blocker() {
    Scene scene = test::faces_of({square({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), square({0, 0, 1}, {0, 1, 0}, {1, 0, 0}),
                                  square({0.25, 0.25, 0.5}, {0.5, 0, 0}, {0, 0.5, 0})},
                                 false);
    scene.surfaces[2].face = no_face;
    scene.faces.pop_back();
    return scene;
}

/// The inside of a cube of edge 3 with a cube of edge 1 in its middle; the latter is the last face.
Scene cube_in_cube() {
    Scene scene = make_box(3, 3, 3);
    scene.empty_box.reset();
    scene.faces.emplace_back("inner");
    for (Surface surface : make_box(1, 1, 1).surfaces) {
        parallelogram(surface).corner += Vector3d(1, 1, 1);
        surface.normal *= -1;
        surface.face = 6;
        scene.surfaces.push_back(surface);
    }
    return scene;
}

TEST(PossibleBlockers, AreEmptyInAConvexScene) {
    EXPECT_FALSE(may_be_occluded(make_box(3, 2, 1)));
    Scene unknown = make_box(3, 2, 1);
    unknown.empty_box.reset();
    EXPECT_FALSE(may_be_occluded(unknown)) << "by looking";
    EXPECT_TRUE(may_be_occluded(test::closed_can())) << "a wall around both is not known to keep clear";
}

TEST(PossibleBlockers, LeaveOutSurfacesBehindOrBeside) {
    Scene scene = test::faces_of({square({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), square({0, 0, 1}, {0, 1, 0}, {1, 0, 0}),
                                  square({0, 0, -1}, {1, 0, 0}, {0, 1, 0}), square({2, 0, 0.5}, {1, 0, 0}, {0, 1, 0})},
                                 false);
    EXPECT_TRUE(possible_blockers(scene, scene.surfaces[0], scene.surfaces[1]).empty());
    scene = squares_with_blocker();
    EXPECT_EQ(possible_blockers(scene, scene.surfaces[0], scene.surfaces[1]).size(), 1u);
    EXPECT_TRUE(may_be_occluded(scene));
}

TEST(ExactFormFactors, AreNotGivenWhereOcclusionIsPossible) {
    EXPECT_FALSE(exact_form_factors(squares_with_blocker()));
    EXPECT_FALSE(exact_form_factors(cube_in_cube()));
    Scene plates = squares_with_blocker();
    plates.surfaces.pop_back();
    EXPECT_TRUE(exact_form_factors(plates));
}

// The double-precision test of node pairs against Embree's: the first surface that a ray towards the other point meets
// is the one that the point lies on, or not. 0 differences of 40 000 are found; 1 in 10 000 is allowed, as much as lies
// within single precision of an edge.
TEST(Sees, AgreesWithTracedRays) {
    for (const Scene& scene : {cube_in_cube(), squares_with_blocker(), test::sleeve(), test::concentric_spheres()}) {
        const auto tracer = make_embree_tracer(scene);
        std::mt19937 engine(3);
        std::uniform_real_distribution<double> coordinate(0.001, 0.999);
        std::uniform_int_distribution<std::uint32_t> any(0, static_cast<std::uint32_t>(scene.surfaces.size()) - 1);
        std::size_t looked_at = 0;
        std::size_t hidden = 0;
        std::size_t differences = 0;
        while (looked_at < 10'000) {
            const std::uint32_t a = any(engine);
            const std::uint32_t b = any(engine);
            const Surface& from = scene.surfaces[a];
            const Surface& to = scene.surfaces[b];
            if (a == b || from.face == no_face || to.face == no_face) continue;
            const SurfacePoint p = SurfaceMap(from).at(coordinate(engine), coordinate(engine));
            const SurfacePoint q = SurfaceMap(to).at(coordinate(engine), coordinate(engine));
            const Vector3d apart = q.position - p.position;
            if (apart.dot(p.normal) < 1e-3 || apart.dot(q.normal) > -1e-3) continue;
            ++looked_at;
            const bool seen = sees(p.position, from, q.position, to, possible_blockers(scene, from, to));
            RayBatch ray;
            ray.source = a;
            const Eigen::Vector3f origin = p.position.cast<float>();
            const Eigen::Vector3f direction = apart.cast<float>();
            ray.origin_x = {origin.x()};
            ray.origin_y = {origin.y()};
            ray.origin_z = {origin.z()};
            ray.direction_x = {direction.x()};
            ray.direction_y = {direction.y()};
            ray.direction_z = {direction.z()};
            Hit hit;
            tracer->trace(ray, {&hit, 1});
            hidden += seen ? 0u : 1u;
            differences += seen == (hit.surface == b && hit.received) ? 0u : 1u;
        }
        EXPECT_LE(differences, 1u) << scene.name;
        EXPECT_GT(hidden + (scene.surfaces.size() == 2 ? 1u : 0u), 0u);
    }
}

// 400 000 random pairs a face; the standard error of the kernel average is at most its root mean square, below 0.5,
// over the root of their number: 8e-4. Five of them: alpha below 1e-6; an error of 6.3 standard errors is found with
// power 0.9. The unoccluded factor, 0.1998, lies 100 standard errors away.
TEST(AreaKernel, AccountsForABlocker) {
    const Scene scene = squares_with_blocker();
    const double estimate = area_kernel(scene, {4}, test::PhiloxPoints(1600), PointMap::uniform, {3, 5}, 0)(0, 1);
    FaceHits hits(3);
    const auto tracer = make_embree_tracer(scene);
    auto block = std::make_unique<PointBlock>();
    constexpr std::uint32_t blocks = 1000;
    for (std::uint32_t n = 0; n < blocks; ++n) {
        block->size = block_capacity;
        test::PhiloxPoints(block_capacity).fill({.key = {7, 11}, .trial = n}, 0, *block);
        tracer->shoot(0, undivided, 0, *block, hits);
    }
    const double by_rays = static_cast<double>(hits[1]) / (blocks * block_capacity);
    EXPECT_NEAR(estimate, by_rays,
                5 * std::hypot(8e-4, std::sqrt(by_rays * (1 - by_rays) / (blocks * block_capacity))));
    EXPECT_LT(estimate, 0.15);
}

// Between the ends of a can the integrand is smooth but for the map of a disc at its middle; from the wall to itself it
// is bounded, with another limit in every direction where two points come together, so that nodes converge slowly. The
// tolerance is ten times what twice the nodes change.
TEST(AreaKernel, IntegratesOverRoundShapes) {
    const Scene can = test::closed_can();
    const Enclosure known = closed_cylinder(1, 3);
    const Eigen::MatrixXd coarse = area_kernel(can, {2}, test::GaussPoints(6, 6), PointMap::uniform, {}, 0);
    const Eigen::MatrixXd fine = area_kernel(can, {2}, test::GaussPoints(12, 12), PointMap::uniform, {}, 0);
    for (const auto& [from, to] : {std::pair(0, 1), std::pair(2, 2)}) {
        const double change = std::abs(fine(from, to) - coarse(from, to));
        EXPECT_NEAR(fine(from, to), known.factors(from, to), 10 * change + 1e-12);
        EXPECT_LT(change, 1e-2);
    }
    EXPECT_EQ(fine(0, 0), 0);
}

TEST(AreaKernel, GivesTheSameBitsWhetherOrNotABoxIsKnownToBeEmpty) {
    Scene looked_at = make_box(3, 2, 1);
    looked_at.empty_box.reset();
    const test::PhiloxPoints points(100);
    EXPECT_EQ(area_kernel(make_box(3, 2, 1), {3}, points, PointMap::graded, {1, 2}, 4),
              area_kernel(looked_at, {3}, points, PointMap::graded, {1, 2}, 4));
}

}  // namespace
}  // namespace ff

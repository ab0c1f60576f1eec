// The analytic and the general tracer, ray by ray.

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ff {
namespace {

/// How far apart, along the ray and in double precision, a ray meets the planes of two surfaces of a scene.
double gap_between_hits(const Scene& scene, const RayBatch& rays, std::size_t i, std::uint32_t one, std::uint32_t two) {
    const Eigen::Vector3d origin(rays.origin_x[i], rays.origin_y[i], rays.origin_z[i]);
    const Eigen::Vector3d direction(rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]);
    const auto distance = [&](std::uint32_t s) {
        const Surface& surface = scene.surfaces[s];
        return surface.normal.dot(parallelogram(surface).corner - origin) / surface.normal.dot(direction.normalized());
    };
    return std::abs(distance(one) - distance(two));
}

struct Agreement {
    std::uint64_t rays = 0;
    std::uint64_t ties = 0;      ///< rays for which the tracers name different surfaces
    double widest_tie = 0;       ///< largest gap_between_hits of these
    float coordinate_error = 0;  ///< largest difference of s or t where they name the same
};

Agreement compare(const Scene& scene, std::uint32_t blocks) {
    const auto box = make_box_tracer(scene);
    const auto embree = make_embree_tracer(scene);
    Agreement result;
    RayBatch rays;
    std::array<Hit, block_capacity> first;
    std::array<Hit, block_capacity> second;
    for (std::uint32_t number = 0; number < blocks; ++number) {
        const std::uint32_t source = number % 6;
        generate_rays(scene.surfaces[source], source, {13, 13}, number / 6 % 169, *test::random_block(number), rays);
        box->trace(rays, first);
        embree->trace(rays, second);
        result.rays += rays.size();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hit& a = first[i];
            const Hit& b = second[i];
            if (a.surface == b.surface) {
                result.coordinate_error = std::max({result.coordinate_error, std::abs(a.s - b.s), std::abs(a.t - b.t)});
            } else if (a.surface == no_surface || b.surface == no_surface) {
                ADD_FAILURE() << "ray " << i << " of block " << number << " is lost";
            } else {
                ++result.ties;
                result.widest_tie = std::max(result.widest_tie, gap_between_hits(scene, rays, i, a.surface, b.surface));
            }
        }
    }
    return result;
}

// Either tracer rounds a handful of times before it decides, with a relative error of 2^-24 each: only rays that pass
// an edge within `width` = 8 * 2^-24 of the box's diagonal can be seen differently. Rays from all walls together hit
// the walls evenly (reciprocity), so the share of such rays is the area of the strips along the edges, two for each
// edge, over the area of the box. That is the bound on the count, with six standard deviations of a Poisson number.
void expect_agreement(double a, double b, double c, std::uint32_t blocks) {
    const Scene scene = make_box(a, b, c);
    const Agreement agreement = compare(scene, blocks);
    const double width = 8 * 0x1p-24 * std::hypot(a, b, c);
    const double strips = 2 * 4 * (a + b + c) * width / (2 * (a * b + b * c + c * a));
    const double expected = strips * static_cast<double>(agreement.rays);
    EXPECT_LE(agreement.widest_tie, width);
    EXPECT_LE(static_cast<double>(agreement.ties), expected + 6 * std::sqrt(expected));
    EXPECT_LE(agreement.coordinate_error, 8 * 0x1p-24 * std::hypot(a, b, c) / std::min({a, b, c}));
    testing::Test::RecordProperty("ties", static_cast<int>(agreement.ties));
    testing::Test::RecordProperty("rays", static_cast<int>(agreement.rays));
}

TEST(Tracers, AgreeRayByRayInTheCube) {
    expect_agreement(6, 6, 6, 9'800);  // 10 035 200 rays
}

TEST(Tracers, AgreeRayByRayInALongBox) {
    expect_agreement(3, 1.1, 0.7, 2'000);
}

/// Hits by face of the rays that `shoot` shoots, but traced from the stored rays.
FaceHits traced(const Tracer& tracer, const Scene& scene, std::uint32_t source, std::uint32_t patch,
                const PointBlock& block) {
    RayBatch rays;
    generate_rays(scene.surfaces[source], source, {13, 13}, patch, block, rays);
    std::vector<Hit> hits(rays.size());
    tracer.trace(rays, hits);
    FaceHits result(scene.faces.size() + 1);
    for (const Hit& hit : hits) {
        ++result[hit.surface == no_surface ? scene.faces.size()
                                           : static_cast<std::size_t>(scene.surfaces[hit.surface].face)];
    }
    return result;
}

TEST(Tracers, ShootTheRaysThatGenerateRaysStores) {
    const Scene scene = make_box(3, 1.1, 0.7);
    for (const TracerChoice choice : {TracerChoice::box, TracerChoice::embree}) {
        const auto tracer = make_tracer(scene, choice);
        for (std::uint32_t number = 0; number < 600; ++number) {
            const auto block = test::random_block(number, 1 + std::size_t{number} * 31 % block_capacity);
            FaceHits shot(7);
            tracer->shoot(number % 6, {13, 13}, number % 169, *block, shot);
            ASSERT_EQ(shot, traced(*tracer, scene, number % 6, number % 169, *block))
                << tracer->name() << ", block " << number;
        }
    }
}

/// The same box with every wall cut into k x k surfaces.
Scene cut(const Scene& scene, std::uint32_t k) {
    Scene result = scene;
    result.empty_box.reset();
    result.surfaces.clear();
    for (const Surface& surface : scene.surfaces) {
        for (std::uint32_t p = 0; p < k * k; ++p) {
            result.surfaces.push_back({patch(parallelogram(surface), {k, k}, p), surface.normal, surface.face});
        }
    }
    return result;
}

// More surfaces than a ray mask has bits: the filter must exclude the source instead, with the same result. Patch p of
// a wall cut into 8 x 8 and the p-th of its 64 surfaces shoot the same rays, for eighths are exact.
TEST(EmbreeTracer, ExcludesTheSourceAlikeByFilterAndByMask) {
    const Scene whole = make_box(6, 6, 6);
    const auto by_mask = make_embree_tracer(whole);
    const auto by_filter = make_embree_tracer(cut(whole, 8));
    for (std::uint32_t patch = 0; patch < 6 * 64; ++patch) {
        const auto block = test::random_block(patch);
        FaceHits one(7);
        FaceHits two(7);
        by_mask->shoot(patch / 64, {8, 8}, patch % 64, *block, one);
        by_filter->shoot(patch, undivided, 0, *block, two);
        EXPECT_EQ(one, two) << "patch " << patch;
    }
}

// Opaque from both sides: a surface blocks rays that come from behind it, but does not receive them.
TEST(EmbreeTracer, CountsRaysThatEndOnABackAsNeitherHitNorLost) {
    Scene scene = make_box(1, 1, 1);
    scene.empty_box.reset();
    scene.surfaces[5].normal *= -1;
    FaceHits hits(7);
    make_embree_tracer(scene)->shoot(0, undivided, 0, *test::random_block(1), hits);
    EXPECT_EQ(hits[5], 0u);
    EXPECT_EQ(hits[6], 0u);
    EXPECT_LT(std::accumulate(hits.begin(), hits.end(), std::uint64_t{0}), block_capacity - 100);
}

TEST(EmbreeTracer, CountsRaysThatLeaveAnOpenSceneAsLost) {
    Scene scene = make_box(1, 1, 1);
    scene.empty_box.reset();
    scene.surfaces.pop_back();  // no lid
    FaceHits hits(7);
    make_embree_tracer(scene)->shoot(0, undivided, 0, *test::random_block(1), hits);
    EXPECT_EQ(hits[5], 0u);
    EXPECT_GT(hits[6], 100u);
}

}  // namespace
}  // namespace ff

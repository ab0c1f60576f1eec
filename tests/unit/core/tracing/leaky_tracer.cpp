#include "core/tracing/tracer.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ff {
namespace {

/// Exact share of rays from face 1 that end in a crack: 1 - the factors to the faces without their rims.
double exact_leak(const Scene& scene) {
    double kept = 0;
    for (std::size_t to = 1; to < scene.surfaces.size(); ++to) {
        Surface inner = scene.surfaces[to];
        parallelogram(inner).corner += crack_width * (parallelogram(inner).edge_u + parallelogram(inner).edge_v);
        parallelogram(inner).edge_u *= 1 - 2 * crack_width;
        parallelogram(inner).edge_v *= 1 - 2 * crack_width;
        kept += *exact_exchange_area(scene.surfaces[0], inner);
    }
    return 1 - kept / area(scene.surfaces[0].shape);
}

TEST(LeakyTracer, LosesRaysThatFallIntoCracks) {
    const Scene scene = built_in_scene("cube");
    const auto tracer = make_tracer(scene, TracerChoice::leaky);
    constexpr std::uint32_t blocks = 1000;
    FaceHits hits(7);
    for (std::uint32_t i = 0; i < blocks; ++i)
        tracer->shoot(0, {3, 3}, i % 9, *test::random_block(i, block_capacity), hits);
    const double rays = blocks * double{block_capacity};
    EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), 0.0), rays);
    // Alpha 2e-9; a leak that is wrong by 8 standard deviations, about a third, is noticed with probability 0.98.
    const double expected = exact_leak(scene) * rays;
    EXPECT_NEAR(static_cast<double>(hits[6]), expected, 6 * std::sqrt(expected));
    EXPECT_GT(expected, 100);
}

TEST(LeakyTracer, AgreesWithTheSoundTracerAwayFromEdges) {
    const Scene scene = built_in_scene("cube");
    RayBatch rays;
    generate_rays(scene.surfaces[0], 0, undivided, 0, *test::random_block(1, block_capacity), rays);
    std::vector<Hit> leaky(rays.size());
    std::vector<Hit> sound(rays.size());
    make_tracer(scene, TracerChoice::leaky)->trace(rays, leaky);
    make_tracer(scene, TracerChoice::automatic)->trace(rays, sound);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_TRUE(leaky[i].surface == no_surface || leaky[i].surface == sound[i].surface);
    }
}

}  // namespace
}  // namespace ff

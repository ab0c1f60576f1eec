#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ff {
namespace {

const Scene& long_box() {
    static const Scene box = make_box(3, 1.5, 0.7);
    return box;
}

FaceHits shoot_block(const Tracer& tracer, std::uint32_t source, std::uint32_t number, std::size_t size) {
    FaceHits hits(7);
    tracer.shoot(source, {13, 13}, number % 169, *test::random_block(number, size), hits);
    return hits;
}

TEST(BoxTracer, CountsTheSameHitsWithEveryInstructionSet) {
    const auto tracer = make_box_tracer(long_box());
    const auto results = test::with_each_instruction_set([&tracer] {
        std::vector<FaceHits> all;
        for (std::uint32_t number = 0; number < 300; ++number) {
            all.push_back(shoot_block(*tracer, number % 6, number, 1 + std::size_t{number} * 17 % block_capacity));
        }
        return all;
    });
    for (const auto& result : results) EXPECT_EQ(result, results.front());
}

TEST(BoxTracer, CountsEveryPointOnceWhateverTheBlockSize) {
    const auto tracer = make_box_tracer(long_box());
    for (std::size_t size = 0; size <= 130; ++size) {
        const FaceHits hits = shoot_block(*tracer, 2, 5, size);
        EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), std::uint64_t{0}), size);
        EXPECT_EQ(hits[2], 0u) << "a flat surface does not hit itself";
        EXPECT_EQ(hits[6], 0u) << "a box is closed";
    }
}

TEST(BoxTracer, AddsToTheHitsItIsGiven) {
    const auto tracer = make_box_tracer(long_box());
    FaceHits hits(7, 1000);
    tracer->shoot(0, undivided, 0, *test::random_block(3), hits);
    EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), std::uint64_t{0}), 7000 + block_capacity);
}

/// Rays in the coordinates of face 1 of the box, z = 0.
RayBatch ray(Eigen::Vector3f origin, Eigen::Vector3f direction) {
    return {{origin.x()}, {origin.y()}, {origin.z()}, {direction.x()}, {direction.y()}, {direction.z()}, 0};
}

Hit trace_one(const RayBatch& rays) {
    Hit hit;
    make_box_tracer(long_box())->trace(rays, {&hit, 1});
    return hit;
}

TEST(BoxTracer, FindsTheWallAndThePlaceOnIt) {
    const Hit opposite = trace_one(ray({1.5f, 0.75f, 0}, {1, 0.5f, 0.7f}));
    EXPECT_EQ(opposite.surface, 5u);
    const Parallelogram& shape = parallelogram(long_box().surfaces[5]);
    const Eigen::Vector3d at = shape.corner + opposite.s * shape.edge_u + opposite.t * shape.edge_v;
    EXPECT_LT((at - Eigen::Vector3d(2.5, 1.25, 0.7)).norm(), 1e-6);

    EXPECT_EQ(trace_one(ray({1, 1, 0}, {0, 1, 0.1f})).surface, 1u) << "face 2, y = b";
    EXPECT_EQ(trace_one(ray({1, 1, 0}, {0, -1, 0.1f})).surface, 2u) << "face 3, y = 0";
    EXPECT_EQ(trace_one(ray({1, 1, 0}, {-1, 0, 0.1f})).surface, 3u) << "face 4, x = 0";
    EXPECT_EQ(trace_one(ray({1, 1, 0}, {1, 0, 0.1f})).surface, 4u) << "face 5, x = a";
}

TEST(BoxTracer, FollowsRaysAlongWallsAndOnTheFloor) {
    EXPECT_EQ(trace_one(ray({0, 1, 0}, {0, 0, 1})).surface, 5u) << "up the wall x = 0";
    EXPECT_EQ(trace_one(ray({0, 0, 0}, {0, 0, 1})).surface, 5u) << "up the corner";
    EXPECT_EQ(trace_one(ray({0, 1, 0}, {0, 1, 0.1f})).surface, 1u) << "along the wall x = 0";
    EXPECT_EQ(trace_one(ray({1, 1, 0}, {1, 0, 0})).surface, 4u) << "on the floor";
}

TEST(BoxTracer, LosesRaysThatPointBehindTheirSurface) {
    EXPECT_EQ(trace_one(ray({1, 1, 0}, {0.1f, 0, -1})).surface, no_surface);
}

}  // namespace
}  // namespace ff

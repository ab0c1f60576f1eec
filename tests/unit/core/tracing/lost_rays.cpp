// No ray may slip out of a closed box, least of all where three walls meet.

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/tracing/tracer.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/unit/core/tracing/point_blocks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

namespace ff {
namespace {

using Place = std::array<float, 3>;

/// Places along one axis: both ends, their neighbours among the floats, and some in between.
std::vector<float> places(float edge, const PointBlock& block, std::size_t dimension) {
    std::vector<float> result{0, 0x1p-149f, 0x1p-24f * edge, edge * (1 - 0x1p-23f), edge * (1 - 0x1p-24f), edge};
    for (std::size_t i = 0; i < 8; ++i) {
        result.push_back(static_cast<float>(block.coordinate[dimension][i]) * 0x1p-32f * edge);
    }
    return result;
}

/// Whether a place lies on (or next to) at least one edge: two coordinates near an end.
bool on_edge(const Place& place, const std::array<float, 3>& edges) {
    int ends = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (place[axis] < 1e-5f * edges[axis] || place[axis] > (1 - 1e-5f) * edges[axis]) ++ends;
    }
    return ends >= 2;
}

std::vector<Place> grid(const std::array<float, 3>& edges, std::uint32_t number) {
    const auto block = test::random_block(number, 8);
    std::vector<Place> result;
    for (const float x : places(edges[0], *block, 0)) {
        for (const float y : places(edges[1], *block, 1)) {
            for (const float z : places(edges[2], *block, 2)) result.push_back({x, y, z});
        }
    }
    return result;
}

/// Rays from every place on surface `source` to every place on an edge or corner that lies in front of it.
void add_rays(const Scene& scene, std::uint32_t source, const std::vector<Place>& grid_places, RayBatch& rays) {
    const Eigen::Vector3f normal = scene.surfaces[source].normal.cast<float>();
    const Eigen::Vector3f corner = parallelogram(scene.surfaces[source]).corner.cast<float>();
    const Eigen::Vector3f box = scene.empty_box->cast<float>();
    rays = {};
    rays.source = source;
    for (const Place& from : grid_places) {
        const Eigen::Vector3f origin(from[0], from[1], from[2]);
        if (normal.dot(origin) != normal.dot(corner)) continue;
        for (const Place& to : grid_places) {
            if (!on_edge(to, {box.x(), box.y(), box.z()})) continue;
            const Eigen::Vector3f direction = Eigen::Vector3f(to[0], to[1], to[2]) - origin;
            // Flatter and shorter ones cannot come from 24-bit coordinates.
            const float length = direction.norm();
            if (length < 0x1p-24f || normal.dot(direction) < 0x1p-12f * length) continue;
            rays.origin_x.push_back(origin.x());
            rays.origin_y.push_back(origin.y());
            rays.origin_z.push_back(origin.z());
            rays.direction_x.push_back(direction.x());
            rays.direction_y.push_back(direction.y());
            rays.direction_z.push_back(direction.z());
        }
    }
}

std::uint64_t count_lost(const Tracer& tracer, const RayBatch& rays, std::vector<Hit>& hits) {
    hits.resize(rays.size());
    tracer.trace(rays, hits);
    return static_cast<std::uint64_t>(
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.surface == no_surface; }));
}

struct Losses {
    std::uint64_t rays = 0;
    std::uint64_t box = 0;
    std::uint64_t embree = 0;
};

void shoot_at_edges(const Scene& scene, std::uint32_t repeats, Losses& losses) {
    const auto box = make_box_tracer(scene);
    const auto embree = make_embree_tracer(scene);
    const Eigen::Vector3f edges = scene.empty_box->cast<float>();
    RayBatch rays;
    std::vector<Hit> hits;
    for (std::uint32_t number = 0; number < repeats; ++number) {
        const std::vector<Place> grid_places = grid({edges.x(), edges.y(), edges.z()}, number);
        for (std::uint32_t source = 0; source < 6; ++source) {
            add_rays(scene, source, grid_places, rays);
            losses.rays += rays.size();
            losses.box += count_lost(*box, rays, hits);
            losses.embree += count_lost(*embree, rays, hits);
        }
    }
}

TEST(LostRays, DoNotOccurAtEdgesAndCorners) {
    Losses losses;
    const auto repeats = static_cast<std::uint32_t>(test::repetitions(2, 7));
    shoot_at_edges(make_box(6, 6, 6), repeats, losses);
    shoot_at_edges(make_box(3, 1.1, 0.7), repeats, losses);
    EXPECT_GT(losses.rays, repeats * 1'500'000u);
    EXPECT_EQ(losses.box, 0u);
    EXPECT_EQ(losses.embree, 0u);
}

// Checks the check: a box with a slit of 1e-4 along one edge does lose rays.
TEST(LostRays, AreFoundThroughASlit) {
    Scene leaky = make_box(6, 6, 6);
    parallelogram(leaky.surfaces[5]).edge_u *= 1 - 1e-4;
    RayBatch rays;
    std::vector<Hit> hits;
    add_rays(leaky, 0, grid({6, 6, 6}, 0), rays);
    EXPECT_GT(count_lost(*make_embree_tracer(leaky), rays, hits), 0u);
}

}  // namespace
}  // namespace ff

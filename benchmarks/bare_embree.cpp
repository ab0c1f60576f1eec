// The cost that our tracer adds to Embree: the same rays through `Tracer::shoot` and through a bare loop of
// rtcIntersect8, patch by patch in turn, so that other load on the machine affects both.

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/tracing/embree_version.hpp"
#include "core/tracing/tracer.hpp"
#include "samplers/sampler.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <vector>

namespace {

using namespace ff;

/// Seconds of processor time of this thread: unlike wall time it does not count what other programs take.
double seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr Subdivision subdivision{13};
constexpr Grid grid{13, 13};
constexpr std::size_t samples = 624;  // whole packets

/// The cube as six quads, one bit of the ray mask each.
class BareScene {
  public:
    explicit BareScene(const Scene& scene) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
        for (unsigned i = 0; i < scene.surfaces.size(); ++i) add(parallelogram(scene.surfaces[i]), i);
        rtcCommitScene(scene_.get());
    }

    [[nodiscard]] RTCScene get() const { return scene_.get(); }

  private:
    void add(const Parallelogram& shape, unsigned index) {
        const embree::GeometryHandle handle(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_QUAD));
        RTCGeometry geometry = handle.get();
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4));
        auto* corners = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), 1));
        for (unsigned i = 0; i < 4; ++i) {
            const Eigen::Vector3d at =
                shape.corner + (i == 1 || i == 2) * shape.edge_u + (i == 2 || i == 3) * shape.edge_v;
            for (unsigned axis = 0; axis < 3; ++axis) vertices[3 * i + axis] = static_cast<float>(at[axis]);
            corners[i] = i;
        }
        rtcSetGeometryMask(geometry, 1u << index);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene_.get(), geometry, index);
    }

    embree::Device device_;
    embree::SceneHandle scene_;
};

void pack(const RayBatch& rays, std::vector<RTCRayHit8>& packets) {
    for (std::size_t k = 0; k < packets.size(); ++k) {
        RTCRayHit8& p = packets[k];
        const auto load = [k](const std::vector<float>& from, float* to) { std::copy_n(&from[8 * k], 8, to); };
        load(rays.origin_x, p.ray.org_x);
        load(rays.origin_y, p.ray.org_y);
        load(rays.origin_z, p.ray.org_z);
        load(rays.direction_x, p.ray.dir_x);
        load(rays.direction_y, p.ray.dir_y);
        load(rays.direction_z, p.ray.dir_z);
        std::fill_n(p.ray.tnear, 8, 0.0f);
        std::fill_n(p.ray.tfar, 8, std::numeric_limits<float>::infinity());
        std::fill_n(p.ray.mask, 8, ~(1u << rays.source));
        std::fill_n(p.hit.geomID, 8, RTC_INVALID_GEOMETRY_ID);
    }
}

void embree_beside_bare_loop(benchmark::State& state) {
    const Scene scene = make_box(6, 6, 6);
    const BareScene bare_scene(scene);
    const auto tracer = make_embree_tracer(scene);
    const auto points = samplers::find("random").make({.points = samples});
    std::vector<RTCRayHit8> packets(samples / 8);
    alignas(32) std::array<int, 8> valid{};
    valid.fill(-1);
    embree::QueryContext context;
    embree::init(context);
    PointBlock block;
    block.size = samples;
    RayBatch rays;
    FaceHits hits(7);
    FaceHits bare_hits(7);
    double ours = 0;
    double bare = 0;
    for (auto _ : state) {
        for (std::uint32_t patch = 0; patch < subdivision.patches(scene); ++patch) {
            const std::uint32_t source = patch / subdivision.per_part();
            const std::uint32_t within = patch % subdivision.per_part();
            points->fill({.key = {1, 2}, .source = patch}, 0, block);
            generate_rays(scene.surfaces[source], source, grid, within, block, rays);
            pack(rays, packets);
            const auto start = seconds();
            for (RTCRayHit8& packet : packets) embree::intersect8(valid.data(), bare_scene.get(), context, packet);
            const auto middle = seconds();
            tracer->shoot(source, grid, within, block, hits);
            const auto end = seconds();
            bare += middle - start;
            ours += end - middle;
            for (const RTCRayHit8& packet : packets) {
                for (const unsigned id : packet.hit.geomID) ++bare_hits[std::min(id, 6u)];
            }
        }
    }
    if (hits != bare_hits) state.SkipWithError("the bare loop hits something else");
    const double rays_shot =
        static_cast<double>(state.iterations()) * static_cast<double>(subdivision.patches(scene) * samples);
    state.counters["bare_rays_per_s"] = rays_shot / bare;
    state.counters["our_rays_per_s"] = rays_shot / ours;
    state.counters["ours_to_bare"] = bare / ours;
}
BENCHMARK(embree_beside_bare_loop)->Unit(benchmark::kMillisecond)->MinTime(2);

}  // namespace

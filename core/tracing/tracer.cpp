#include "core/tracing/tracer.hpp"

#include "core/geometry/placement.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/tracing/fine_detail.hpp"
#include "core/visibility/mirrors.hpp"

#include <utility>

namespace ff {
namespace {

std::unique_ptr<Tracer> make_straight_tracer(const Scene& scene, TracerChoice choice) {
    if (choice == TracerChoice::box && !scene.empty_box) {
        throw UserError("tracer: the box tracer cannot do scene '" + scene.name +
                        "' (it knows only the inside of an empty box). Choose embree or automatic.");
    }
    if (choice != TracerChoice::embree && scene.empty_box) return make_box_tracer(scene);
    return has_fine_detail(scene) ? make_double_tracer(scene) : make_embree_tracer(scene);
}

}  // namespace

void Tracer::find_ends(const Surface& surface, std::uint32_t source, Grid grid, std::uint32_t patch,
                       const PointBlock& block, std::span<Hit> hits) const {
    RayBatch rays;
    generate_rays(surface, source, grid, patch, block, rays);
    trace(rays, hits);
}

void shoot_by_tracing(const Tracer& tracer, const Scene& scene, std::uint32_t source, Grid grid, std::uint32_t patch,
                      const PointBlock& block, std::span<std::uint64_t> hits) {
    FF_EXPECT(hits.size() == scene.faces.size() + 1);
    std::vector<Hit> found(block.size);
    tracer.find_ends(scene.surfaces[source], source, grid, patch, block, found);
    for (const Hit& hit : found) {
        if (hit.surface == no_surface) {
            ++hits[scene.faces.size()];
        } else if (hit.received) {
            ++hits[static_cast<std::size_t>(scene.surfaces[hit.surface].face)];
        }
    }
}

std::unique_ptr<Tracer> make_tracer(const Scene& given, TracerChoice choice) {
    const Scene scene = placed(given);
    if (choice == TracerChoice::leaky) return make_leaky_tracer(scene);
    auto tracer = make_straight_tracer(scene, choice);
    return mirrors(scene).empty() ? std::move(tracer) : make_mirror_tracer(scene, std::move(tracer));
}

}  // namespace ff

#include "core/tracing/tracer.hpp"

#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "core/tracing/fine_detail.hpp"
#include "core/tracing/leaky_tracer.hpp"
#include "core/tracing/mirror_tracer.hpp"
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

std::unique_ptr<Tracer> make_tracer(const Scene& given, TracerChoice choice) {
    const Scene scene = placed(given);
    if (choice == TracerChoice::leaky) return make_leaky_tracer(scene);
    auto tracer = make_straight_tracer(scene, choice);
    return mirrors(scene).empty() ? std::move(tracer) : make_mirror_tracer(scene, std::move(tracer));
}

}  // namespace ff

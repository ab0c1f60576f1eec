#include "core/shoot_by_tracing.hpp"

#include "core/contract.hpp"

#include <vector>

namespace ff {

void shoot_by_tracing(const Tracer& tracer, const Scene& scene, std::uint32_t source, Grid grid, std::uint32_t patch,
                      const PointBlock& block, std::span<std::uint64_t> hits) {
    FF_EXPECT(hits.size() == scene.faces.size() + 1);
    RayBatch rays;
    generate_rays(scene.surfaces[source], source, grid, patch, block, rays);
    std::vector<Hit> found(rays.size());
    tracer.trace(rays, found);
    for (const Hit& hit : found) {
        if (hit.surface == no_surface) {
            ++hits[scene.faces.size()];
        } else if (hit.received) {
            ++hits[static_cast<std::size_t>(scene.surfaces[hit.surface].face)];
        }
    }
}

}  // namespace ff

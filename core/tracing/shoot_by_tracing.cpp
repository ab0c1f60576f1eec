#include "core/tracing/shoot_by_tracing.hpp"

#include "core/support/contract.hpp"

#include <vector>

namespace ff {

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

}  // namespace ff

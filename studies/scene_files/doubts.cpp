#include "core/mirrors.hpp"
#include "core/stream.hpp"
#include "core/tracer.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace ff::studies {
namespace {

constexpr std::size_t most_surfaces = 65536;
constexpr std::size_t most_probed = 1000;
constexpr std::size_t rays_of_a_surface = 64;

/// What became of the probing rays of one face.
struct Probe {
    std::size_t rays = 0;
    std::size_t lost = 0;
    std::size_t on_backs = 0;
    std::uint32_t back = no_surface;  ///< a surface whose back was met
};

/// The same points whatever is asked: they decide nothing but a warning.
std::unique_ptr<PointBlock> points() {
    auto block = std::make_unique<PointBlock>();
    block->size = rays_of_a_surface;
    for (std::uint32_t i = 0; i < rays_of_a_surface; ++i) {
        const Words words = philox({}, i, Purpose::coordinates);
        for (std::size_t d = 0; d < words.size(); ++d) block->coordinate[d][i] = words[d];
    }
    return block;
}

}  // namespace

std::vector<std::string> doubts_about(const Scene& scene) {
    if (scene.surfaces.size() > most_surfaces) return {};
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    const auto block = points();
    std::vector<Probe> probes(scene.faces.size());
    std::vector<Hit> hits(rays_of_a_surface);
    RayBatch rays;
    const std::size_t step = scene.surfaces.size() / most_probed + 1;
    for (std::size_t s = 0; s < scene.surfaces.size(); s += step) {
        const Surface& surface = scene.surfaces[s];
        if (!is_of_face(surface)) continue;
        Probe& probe = probes[static_cast<std::size_t>(surface.face)];
        generate_rays(surface, static_cast<std::uint32_t>(s), undivided, 0, *block, rays);
        tracer->trace(rays, hits);
        probe.rays += hits.size();
        for (const Hit& hit : hits) {
            if (hit.surface == no_surface) {
                ++probe.lost;
            } else if (!hit.received && is_of_face(scene.surfaces[hit.surface])) {
                ++probe.on_backs;
                probe.back = hit.surface;
            }
        }
    }
    std::vector<std::string> doubts;
    for (std::size_t face = 0; face < probes.size(); ++face) {
        const Probe& probe = probes[face];
        const auto say = [&](std::size_t count, const std::string& what) {
            doubts.push_back(fmt::format("scene '{}': {} of {} rays from face '{}' {}", scene.name, count, probe.rays,
                                         scene.faces[face], what));
        };
        if (scene.closed && probe.lost > 0)
            say(probe.lost,
                "meet nothing, though the scene is said to be closed (a hole, or normals that face outwards)");
        if (2 * probe.on_backs > probe.rays) {
            const auto other = static_cast<std::size_t>(scene.surfaces[probe.back].face);
            say(probe.on_backs,
                fmt::format("end on backs, one of them of face '{}' (normals of either may face the wrong way)",
                            scene.faces[other]));
        }
    }
    return doubts;
}

}  // namespace ff::studies

#include "studies/scene_files/orientation.hpp"

#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <memory>

namespace ff::studies {
namespace {

constexpr std::size_t most_probed = 1000;
constexpr std::size_t rays_of_a_surface = 64;
/// A surface with less of its face's area is not probed: rays from it would count as much as those from the rest.
constexpr double least_share_probed = 1e-6;

/// Turning faces one after another takes time proportional to the cube of their number.
constexpr std::size_t most_faces_turned = 256;

/// The same points for every request: they affect only messages.
std::unique_ptr<PointBlock> points() {
    auto block = std::make_unique<PointBlock>();
    block->size = rays_of_a_surface;
    for (std::uint32_t i = 0; i < rays_of_a_surface; ++i) {
        const Words words = philox({}, i, Purpose::coordinates);
        for (std::size_t d = 0; d < words.size(); ++d) block->coordinate[d][i] = words[d];
    }
    return block;
}

Scene turned_round(Scene scene) {
    for (Surface& surface : scene.surfaces) {
        surface.normal = -surface.normal;
        const auto turn = [](Facing& facing) { facing = facing == Facing::outward ? Facing::inward : Facing::outward; };
        if (auto* wall = std::get_if<Frustum>(&surface.shape)) turn(wall->facing);
        if (auto* zone = std::get_if<SphereZone>(&surface.shape)) turn(zone->facing);
    }
    scene.empty_box.reset();
    return scene;
}

/// Shoots rays from surfaces of faces: `visit(surface, hits)` returns whether to go on.
template <class Visit>
void shoot_from_faces(const Scene& scene, Visit visit) {
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    const auto block = points();
    std::vector<Hit> hits(rays_of_a_surface);
    std::vector<double> areas(scene.faces.size());
    for (const Surface& surface : scene.surfaces) {
        if (is_of_face(surface)) areas[static_cast<std::size_t>(surface.face)] += area(surface.shape);
    }
    const std::size_t step = scene.surfaces.size() / most_probed + 1;
    for (std::size_t s = 0; s < scene.surfaces.size(); s += step) {
        const Surface& surface = scene.surfaces[s];
        if (!is_of_face(surface)) continue;
        if (area(surface.shape) < least_share_probed * areas[static_cast<std::size_t>(surface.face)]) continue;
        tracer->find_ends(surface, static_cast<std::uint32_t>(s), undivided, 0, *block, hits);
        if (!visit(surface, hits)) return;
    }
}

std::size_t count_lost(const std::vector<Hit>& hits) {
    return static_cast<std::size_t>(std::ranges::count(hits, no_surface, &Hit::surface));
}

void probe(const Scene& scene, std::size_t side, SideProbes& probes) {
    shoot_from_faces(scene, [&](const Surface& surface, const std::vector<Hit>& hits) {
        const auto from = static_cast<std::size_t>(surface.face);
        for (const Hit& hit : hits) {
            if (hit.surface == no_surface || !is_of_face(scene.surfaces[hit.surface])) continue;
            const auto to = static_cast<std::size_t>(scene.surfaces[hit.surface].face);
            ++probes.met(from, side, to, hit.received ? side : 1 - side);
        }
        const std::size_t lost = count_lost(hits);
        probes.rays[2 * from + side] += hits.size();
        probes.lost[2 * from + side] += lost;
        if (side == 0) {
            probes.area += area(surface.shape);
            probes.area_lost += area(surface.shape) * static_cast<double>(lost) / static_cast<double>(hits.size());
        }
        return true;
    });
}

/// Rays that end where none should, given the side that each face radiates to.
std::size_t wrong_ends(const SideProbes& probes, const std::vector<std::size_t>& side, bool closed) {
    std::size_t sum = 0;
    for (std::size_t from = 0; from < probes.faces; ++from) {
        if (closed) sum += probes.lost[2 * from + side[from]];
        for (std::size_t to = 0; to < probes.faces; ++to) sum += probes.met(from, side[from], to, 1 - side[to]);
    }
    return sum;
}

/// Rays that end on the radiating side of a face.
std::size_t good_ends(const SideProbes& probes, const std::vector<std::size_t>& side) {
    std::size_t sum = 0;
    for (std::size_t from = 0; from < probes.faces; ++from) {
        for (std::size_t to = 0; to < probes.faces; ++to) sum += probes.met(from, side[from], to, side[to]);
    }
    return sum;
}

/// Turns one face after another as long as that helps. @return wrong ends that are left
std::size_t improve(const SideProbes& probes, std::vector<std::size_t>& side, bool closed) {
    std::size_t least = wrong_ends(probes, side, closed);
    for (std::size_t turn = 0; turn < probes.faces; ++turn) {
        std::size_t best = probes.faces;
        for (std::size_t face = 0; face < probes.faces; ++face) {
            side[face] = 1 - side[face];
            const std::size_t wrong = wrong_ends(probes, side, closed);
            side[face] = 1 - side[face];
            if (wrong < least) {
                least = wrong;
                best = face;
            }
        }
        if (best == probes.faces) break;
        side[best] = 1 - side[best];
    }
    return least;
}

}  // namespace

SideProbes probe_sides(const Scene& given) {
    const Scene scene = placed(given);
    SideProbes probes(scene.faces.size());
    probe(scene, 0, probes);
    probe(turned_round(scene), 1, probes);
    return probes;
}

std::vector<std::size_t> turned_faces(const SideProbes& probes, bool closed) {
    std::vector<std::size_t> as_it_is(probes.faces, 0);
    std::size_t rays = 0;
    for (std::size_t face = 0; face < probes.faces; ++face) rays += probes.rays[2 * face];
    const std::size_t wrong = wrong_ends(probes, as_it_is, closed);
    if (20 * wrong < rays || probes.faces > most_faces_turned) return {};
    std::vector<std::size_t> best;
    for (const std::size_t start : {std::size_t{0}, std::size_t{1}}) {
        std::vector<std::size_t> side(probes.faces, start);
        const std::size_t left = improve(probes, side, closed);
        // Rays that no longer end on backs have to end on fronts: turning a face away from all others explains nothing.
        const bool explains =
            10 * left <= wrong && 2 * good_ends(probes, side) >= 2 * good_ends(probes, as_it_is) + wrong;
        std::vector<std::size_t> turned;
        for (std::size_t face = 0; face < probes.faces; ++face) {
            if (side[face] == 1) turned.push_back(face);
        }
        if (explains && (best.empty() || turned.size() < best.size())) best = turned;
    }
    return best;
}

std::optional<std::size_t> face_open_to_outside(const Scene& given) {
    std::optional<std::size_t> open;
    shoot_from_faces(placed(given), [&](const Surface& surface, const std::vector<Hit>& hits) {
        if (2 * count_lost(hits) > hits.size()) open = static_cast<std::size_t>(surface.face);
        return !open;
    });
    return open;
}

}  // namespace ff::studies

#include "studies/scene_files/orientation.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/points/stream.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// A surface that an edge belongs to.
struct Side {
    std::uint32_t low = 0, high = 0;  ///< numbers of the edge's ends
    int face = 0;
    std::uint32_t surface = 0;
    bool forwards = false;  ///< it runs through the edge from `low` to `high`, counter-clockwise around its normal
};

std::vector<Side> sides_of(const Scene& scene) {
    PlaceNumbers number(resolution_of_places *
                        std::max(farthest_coordinate(scene), std::numeric_limits<double>::min()));
    std::vector<Side> sides;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face < 0) continue;
        numbers.clear();
        for (const Vector3d& corner : outline(surface)) numbers.push_back(number(corner));
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto [low, high] = std::minmax(numbers[k], next_corner(numbers, k));
            sides.push_back({low, high, surface.face, s, numbers[k] == low});
        }
    }
    return sides;
}

/// Calls use(first, second) for edges that exactly two surfaces have. An edge where bodies or fins meet says nothing.
template <class Use>
void for_each_common_edge(std::vector<Side>& sides, const Use& use) {
    const auto key = [](const Side& side) { return std::pair(side.low, side.high); };
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return std::pair(key(a), a.surface) < std::pair(key(b), b.surface);
    });
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && key(sides[end]) == key(sides[begin])) ++end;
        if (end - begin == 2) use(sides[begin], sides[begin + 1]);
    }
}

/// Surfaces that are joined, each with whether it faces the other way than the first.
struct Part {
    std::vector<std::pair<std::uint32_t, bool>> surfaces;
    bool is_one_sided = false;  ///< like Möbius's strip
};

std::vector<Part> parts_of(std::size_t surfaces,
                           const std::vector<std::vector<std::pair<std::uint32_t, bool>>>& joined) {
    constexpr char unseen = 2;
    std::vector<char> side(surfaces, unseen);
    std::vector<Part> parts;
    for (std::uint32_t first = 0; first < surfaces; ++first) {
        if (side[first] != unseen || joined[first].empty()) continue;
        Part part;
        side[first] = 0;
        part.surfaces.emplace_back(first, false);
        for (std::size_t next = 0; next < part.surfaces.size(); ++next) {
            const auto [surface, turned] = part.surfaces[next];
            for (const auto& [other, same_way] : joined[surface]) {
                const char wanted = turned != same_way ? 1 : 0;
                if (side[other] == unseen) {
                    side[other] = wanted;
                    part.surfaces.emplace_back(other, wanted == 1);
                } else {
                    part.is_one_sided = part.is_one_sided || side[other] != wanted;
                }
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The area of other faces that a surface faces and that face it. @param sign  -1 where it is turned round
double area_seen(const Scene& scene, std::uint32_t index, double sign) {
    const Surface& surface = scene.surfaces[index];
    const auto middle_of = [](const Surface& any) {
        const Extent x = extent(any, Vector3d::UnitX()), y = extent(any, Vector3d::UnitY()),
                     z = extent(any, Vector3d::UnitZ());
        return Vector3d((x.low + x.high) / 2, (y.low + y.high) / 2, (z.low + z.high) / 2);
    };
    double sum = 0;
    for (const Surface& other : scene.surfaces) {
        if (other.face < 0 || other.face == surface.face || !is_flat(other.shape)) continue;
        const Vector3d between = middle_of(other) - middle_of(surface);
        if (sign * surface.normal.dot(between) > 0 && other.normal.dot(between) < 0) sum += area(other.shape);
    }
    return sum;
}

constexpr std::size_t most_probed = 1000;
constexpr std::size_t rays_of_a_surface = 64;

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

void probe(const Scene& scene, std::size_t side, SideProbes& probes) {
    const auto tracer = make_tracer(scene, TracerChoice::automatic);
    const auto block = points();
    std::vector<Hit> hits(rays_of_a_surface);
    const std::size_t step = scene.surfaces.size() / most_probed + 1;
    for (std::size_t s = 0; s < scene.surfaces.size(); s += step) {
        const Surface& surface = scene.surfaces[s];
        if (!is_of_face(surface)) continue;
        const auto from = static_cast<std::size_t>(surface.face);
        tracer->find_ends(surface, static_cast<std::uint32_t>(s), undivided, 0, *block, hits);
        probes.rays[2 * from + side] += hits.size();
        for (const Hit& hit : hits) {
            if (hit.surface == no_surface) {
                ++probes.lost[2 * from + side];
            } else if (is_of_face(scene.surfaces[hit.surface])) {
                const auto to = static_cast<std::size_t>(scene.surfaces[hit.surface].face);
                ++probes.met(from, side, to, hit.received ? side : 1 - side);
            }
        }
    }
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

Winding find_winding(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(scene.surfaces.size());
    bool any = false;
    for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face) return;
        const bool same_way = a.forwards == b.forwards;
        any = any || same_way;
        joined[a.surface].emplace_back(b.surface, same_way);
        joined[b.surface].emplace_back(a.surface, same_way);
    });
    Winding winding;
    if (!any) return winding;
    for (const Part& part : parts_of(scene.surfaces.size(), joined)) {
        std::array<double, 2> areas{};
        for (const auto& [surface, turned] : part.surfaces)
            areas[turned ? 1 : 0] += area(scene.surfaces[surface].shape);
        if (areas[1] == 0) continue;
        constexpr double rounding = 1e-9;
        bool turn_others = areas[1] < areas[0];
        bool is_decided = std::abs(areas[0] - areas[1]) > rounding * areas[0];
        if (!is_decided) {
            std::array<double, 2> seen{};  // area seen with the others turned; with all but them turned
            for (const auto& [surface, turned] : part.surfaces) {
                seen[0] += area_seen(scene, surface, turned ? -1 : 1);
                seen[1] += area_seen(scene, surface, turned ? 1 : -1);
            }
            turn_others = seen[0] > seen[1];
            is_decided = seen[0] != seen[1];
        }
        if (part.is_one_sided || !is_decided) {
            winding.undecided.push_back(scene.surfaces[part.surfaces.front().first].face);
            continue;
        }
        for (const auto& [surface, turned] : part.surfaces) {
            if (turned == turn_others) winding.turned.push_back(surface);
        }
    }
    std::sort(winding.turned.begin(), winding.turned.end());
    return winding;
}

std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::pair<int, int>> pairs;
    for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face && a.forwards == b.forwards) pairs.push_back(std::minmax(a.face, b.face));
    });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

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

}  // namespace ff::studies

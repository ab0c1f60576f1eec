#include "studies/form_factors/face_pairs.hpp"

#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "core/support/free_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Every pair of surfaces is examined in scenes with at most this many surfaces, or with at most this many per face.
constexpr std::size_t most_surfaces = 4096;
constexpr std::size_t most_surfaces_per_face = 4;

bool is_each_looked_at(const Scene& scene) {
    return scene.surfaces.size() <= std::max(most_surfaces, most_surfaces_per_face * scene.faces.size());
}

/// Cells serve one pair of surfaces. Where two faces have more such pairs than this, rays are cheaper: they serve all
/// pairs at once.
constexpr std::size_t most_pairs_by_cells = 256;

/// Pairs whose bounds are this close to each other, in tolerances, are not sampled.
constexpr double near_enough = 0.5;

/// The pair, with the middle of its bounds from geometry, if these are as narrow as requested.
std::optional<KnownPair> settled(const FacePair& pair, double wanted) {
    const double least = std::max(0.0, pair.known - pair.bound);
    if (!pair.all_unblocked_known || pair.most - least > 2 * near_enough * wanted) return std::nullopt;
    return KnownPair{pair.from,
                     pair.to,
                     (least + pair.most) / 2,
                     (pair.most - least) / 2,
                     ExchangeMethod::bounds,
                     ExchangeReason::small};
}

/// Coordinates of the scene are rounded like the largest of them, which matters for faces that are small beside it.
void add_resolution(const Scene& scene, FacePairs& pairs) {
    constexpr double noticeable = 1e-9;
    const double step = 4 * std::numeric_limits<double>::epsilon() * farthest_coordinate(scene);
    for (FacePair& pair : pairs.pairs) {
        const double size = std::sqrt(std::min(pairs.areas[pair.from], pairs.areas[pair.to]));
        if (step > noticeable * size) pair.resolution = std::min(step, size) * size;
    }
}

void expect_few_faces(const Scene& scene) {
    constexpr std::size_t most = most_dense_faces;
    if (is_each_looked_at(scene) || scene.faces.size() <= most) return;
    throw UserError(
        "scene '{}': {} faces (of {} surfaces, a matrix of at most {} is made). Put surfaces "
        "into groups.",
        scene.name, scene.faces.size(), scene.surfaces.size(), most);
}

/// Leaves all pairs of surfaces to rays.
void leave_all_to_rays(FacePairs& result) {
    for (std::uint32_t from = 0; from < result.faces(); ++from) {
        for (std::uint32_t to = from; to < result.faces(); ++to) {
            result.pairs.push_back({.from = from,
                                    .to = to,
                                    .most = std::min(result.areas[from], result.areas[to]),
                                    .all_unblocked_known = false,
                                    .everything = true,
                                    .reason = ExchangeReason::many_surfaces});
        }
    }
}

/// Orders pairs by their faces.
struct InOrder {
    static auto place(const KnownPair& pair) { return std::tuple(pair.from, pair.to, pair.value); }
    bool operator()(const KnownPair& a, const KnownPair& b) const { return place(a) < place(b); }
};

/// The pairs of all parts, in order.
std::vector<KnownPair> known_of(std::vector<Seen>& parts) {
    std::size_t size = 0;
    for (const Seen& part : parts) size += part.known.size();
    std::vector<KnownPair> all;
    all.reserve(size);
    for (Seen& part : parts) {
        const std::vector<KnownPair> own = std::exchange(part.known, {});
        all.insert(all.end(), own.begin(), own.end());
    }
    std::sort(all.begin(), all.end(), InOrder{});
    return all;
}

/// The sampled pairs of all parts, in order.
SampledPairs sampled_of(std::vector<Seen>& parts, const Occluders& occluders) {
    std::size_t pairs = 0;
    std::size_t blockers = 0;
    for (const Seen& part : parts) {
        pairs += part.open.size();
        blockers += part.open.blockers();
    }
    SampledPairs all(occluders);
    all.reserve(pairs, blockers);
    for (Seen& part : parts) {
        const SampledPairs open = std::exchange(part.open, SampledPairs(occluders));
        for (std::size_t k = 0; k < open.size(); ++k) all.add(open[k], open);
    }
    all.sort();
    return all;
}

/// Drops data that belong to no pair of faces.
void keep_used(FacePairs& geometry) {
    std::size_t pairs = 0;
    std::size_t blockers = 0;
    for (const FacePair& pair : geometry.pairs) {
        pairs += pair.count;
        for (const SampledPair& surfaces : geometry.surfaces_of(pair)) blockers += surfaces.blockers;
    }
    SampledPairs used(*geometry.occluders);
    used.reserve(pairs, blockers);
    for (FacePair& pair : geometry.pairs) {
        const auto first = static_cast<std::uint32_t>(used.size());
        for (const SampledPair& surfaces : geometry.surfaces_of(pair)) used.add(surfaces, geometry.sampled);
        pair.first = first;
    }
    geometry.sampled = std::move(used);
    geometry.pairs.shrink_to_fit();
}

/// Notes which surfaces rays may count between, for pairs that are not left to cells.
void find_shot(const Scene& scene, bool cells, FacePairs& geometry) {
    geometry.shot.resize(scene.surfaces.size());
    for (const FacePair& pair : geometry.pairs) {
        if (cells && pair.by_cells) continue;
        for (const SampledPair& surfaces : geometry.surfaces_of(pair)) {
            geometry.shot[surfaces.from].push_back(surfaces.to);
            if (surfaces.from != surfaces.to) geometry.shot[surfaces.to].push_back(surfaces.from);
        }
    }
    for (std::vector<std::uint32_t>& others : geometry.shot) std::sort(others.begin(), others.end());
}

void add(FacePair& pair, const KnownPair& known) {
    pair.known += known.value;
    pair.bound += known.bound;
    pair.most += known.value + known.bound;
    pair.reason = std::max(pair.reason, known.reason);
}

void add(FacePair& pair, const Scene& scene, const SampledPair& open) {
    pair.reason = std::max(pair.reason, open.reason);
    if (open.is_whole_known()) {
        pair.bound += open.times() * open.whole.error;  // the hidden part may be subtracted from it
        pair.most += open.times() * (open.whole.value + open.whole.error);
    } else {
        pair.all_unblocked_known = false;
        pair.most +=
            open.times() * std::min(area(scene.surfaces[open.from].shape), area(scene.surfaces[open.to].shape));
    }
    ++pair.count;
}

/// Adds up the known pairs of the same faces.
void merge_same(std::vector<KnownPair>& known) {
    std::size_t size = 0;
    for (const KnownPair& pair : known) {
        if (size == 0 || known[size - 1].from != pair.from || known[size - 1].to != pair.to) {
            known[size++] = pair;
            continue;
        }
        KnownPair& sum = known[size - 1];
        sum.value += pair.value;
        sum.bound += pair.bound;
        sum.method = std::max(sum.method, pair.method);
        sum.reason = std::max(sum.reason, pair.reason);
    }
    known.resize(size);
}

/// Sums what surfaces exchange over pairs of faces.
void add_up(const Scene& scene, std::vector<Seen> parts, const Request& request, FacePairs& result) {
    const auto face_of = [&](std::uint32_t surface) { return static_cast<std::size_t>(scene.surfaces[surface].face); };
    for (Seen& part : parts) {
        for (const DroppedPair& little : std::exchange(part.dropped, {})) {
            add_dropped(result.dropped, face_of(little.from), face_of(little.to), 0.5 * (little.least + little.most),
                        little.least, little.most);
        }
    }
    result.known = known_of(parts);
    return_free_memory();
    merge_same(result.known);
    result.sampled = sampled_of(parts, *result.occluders);
    return_free_memory();  // parts are many
    const SampledPairs& open = result.sampled;
    std::vector<KnownPair> small;
    auto known = result.known.begin();
    for (std::size_t first = 0; first < open.size();) {
        FacePair pair;
        pair.from = open[first].face;
        pair.to = open[first].other_face;
        const auto faces = std::pair(pair.from, pair.to);
        known = std::lower_bound(known, result.known.end(), faces, [](const KnownPair& a, const auto& wanted) {
            return std::pair(a.from, a.to) < wanted;
        });
        pair.first = static_cast<std::uint32_t>(first);
        const bool is_partly_known = known != result.known.end() && std::pair(known->from, known->to) == faces;
        if (is_partly_known) add(pair, *known);
        for (; first < open.size() && std::pair(open[first].face, open[first].other_face) == faces; ++first) {
            add(pair, scene, open[first]);
        }
        const double smaller = std::min(result.areas[pair.from], result.areas[pair.to]);
        pair.most = std::min(pair.most, smaller);
        const double wanted = std::max(request.tolerance_between(pair.from, pair.to) * smaller,
                                       request.relative * std::max(0.0, pair.known - pair.bound));
        const auto bounds = settled(pair, wanted);
        if (is_partly_known) known->method = ExchangeMethod::none;  // it is part of another
        if (bounds)
            small.push_back(*bounds);
        else
            result.pairs.push_back(pair);
    }
    std::erase_if(result.known, [](const KnownPair& pair) { return pair.method == ExchangeMethod::none; });
    const auto middle = static_cast<std::ptrdiff_t>(result.known.size());
    result.known.insert(result.known.end(), small.begin(), small.end());
    std::inplace_merge(result.known.begin(), result.known.begin() + middle, result.known.end(), InOrder{});
    keep_used(result);
}

}  // namespace

void add_dropped(std::vector<DroppedExchange>& faces, std::size_t from, std::size_t to, double value, double low,
                 double high) {
    for (const std::size_t face : {from, to}) {
        DroppedExchange& sum = faces[face];
        ++sum.pairs;
        sum.value += value;
        sum.low += low;
        sum.high += high;
    }
}

std::size_t pairs_of(std::size_t faces) {
    return faces * (faces + 1) / 2;
}

FacePairs examine_pairs(const Scene& scene, const Request& request) {
    expect_few_faces(scene);
    const bool looks = is_each_looked_at(scene);
    FacePairs result(std::make_shared<const Occluders>(looks ? scene : Scene{}));
    result.areas.assign(scene.faces.size(), 0);
    result.dropped.resize(scene.faces.size());
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != no_face) result.areas[static_cast<std::size_t>(surface.face)] += area(surface.shape);
    }
    if (!looks) {
        leave_all_to_rays(result);
        add_resolution(scene, result);
        return result;
    }
    add_up(scene, look_at_pairs(scene, result.areas, *result.occluders, request), request, result);
    for (FacePair& pair : result.pairs) {
        const std::span<const SampledPair> surfaces = result.surfaces_of(pair);
        pair.by_cells = pair.count <= most_pairs_by_cells &&
                        std::all_of(surfaces.begin(), surfaces.end(),
                                    [](const SampledPair& sampled) { return sampled.method == ExchangeMethod::cells; });
    }
    find_shot(scene, request.cells, result);
    add_resolution(scene, result);
    return result;
}

void allow_for_rounding(double rounding, const Scene& scene, FacePairs& pairs) {
    if (rounding == 0) return;
    // Edges are at most pi times as long as the diagonals, and are off by sqrt(3) times the rounding. That changes what
    // is exchanged, and the area that it is divided by.
    constexpr double of_diagonals = 16;
    std::vector<double> diagonals(pairs.faces());
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != no_face)
            diagonals[static_cast<std::size_t>(surface.face)] += box_around(surface).diagonal().norm();
    }
    const auto effect = [&](const auto& pair) {
        return of_diagonals * rounding * std::min(diagonals[pair.from], diagonals[pair.to]);
    };
    for (KnownPair& pair : pairs.known) pair.bound += effect(pair);
    for (FacePair& pair : pairs.pairs) pair.resolution = std::max(pair.resolution, effect(pair));
}

}  // namespace ff::studies::form_factors

#include "studies/form_factors/face_pairs.hpp"

#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/look_at_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Every pair of surfaces is looked at in scenes with at most this many surfaces, or with at most this many per face.
constexpr std::size_t most_surfaces = 4096;
constexpr std::size_t most_surfaces_per_face = 4;

bool is_each_looked_at(const Scene& scene) {
    return scene.surfaces.size() <= std::max(most_surfaces, most_surfaces_per_face * scene.faces.size());
}

/// Cells serve one pair of surfaces. Where two faces have more such pairs than this, rays are cheaper: they serve all
/// pairs at once.
constexpr std::size_t most_pairs_by_cells = 256;

/// Pairs whose bounds are this near to each other, in tolerances, are not sampled.
constexpr double near_enough = 0.5;

/// The pair if bounds from geometry are as narrow as is asked for: their middle.
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

/// Coordinates of the scene are rounded like the largest of them. That shows where faces are small beside it.
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
        fmt::format("scene '{}': {} faces (of {} surfaces, a matrix of at most {} is made). Put surfaces "
                    "into groups.",
                    scene.name, scene.faces.size(), scene.surfaces.size(), most));
}

/// Everything is left to rays.
void leave_all_to_rays(FacePairs& result) {
    for (std::uint32_t from = 0; from < result.faces(); ++from) {
        for (std::uint32_t to = from; to < result.faces(); ++to) {
            FacePair& pair = result.pairs.emplace_back();
            pair.from = from;
            pair.to = to;
            pair.everything = true;
            pair.all_unblocked_known = false;
            pair.reason = ExchangeReason::many_surfaces;
            pair.most = std::min(result.areas[from], result.areas[to]);
        }
    }
}

/// By their faces.
struct InOrder {
    static auto place(const KnownPair& pair) { return std::tuple(pair.from, pair.to, pair.value); }
    static auto place(const OpenPair& pair) {
        return std::tuple(pair.face, pair.other_face, pair.surfaces.from, pair.surfaces.to);
    }
    template <class Pair>
    bool operator()(const Pair& a, const Pair& b) const {
        return place(a) < place(b);
    }
};

/// Those of all parts, in order.
template <class Pair>
std::vector<Pair> together(std::vector<Seen>& parts, std::vector<Pair> Seen::*of_part) {
    std::size_t size = 0;
    for (const Seen& part : parts) size += (part.*of_part).size();
    std::vector<Pair> all;
    all.reserve(size);
    for (Seen& part : parts) {
        for (Pair& pair : part.*of_part) all.push_back(std::move(pair));
        part.*of_part = {};
    }
    std::sort(all.begin(), all.end(), InOrder{});
    return all;
}

void add(FacePair& pair, const KnownPair& known) {
    pair.known += known.value;
    pair.bound += known.bound;
    pair.most += known.value + known.bound;
    pair.reason = std::max(pair.reason, known.reason);
}

void add(FacePair& pair, const Scene& scene, OpenPair open) {
    const auto& [from, to, times, exchange] = open.surfaces;
    pair.reason = std::max(pair.reason, exchange.reason);
    if (exchange.area) {
        pair.bound += times * exchange.area->error;  // it may be what the hidden part is taken off
        pair.most += times * (exchange.area->value + exchange.area->error);
    } else {
        pair.all_unblocked_known = false;
        pair.most += times * std::min(area(scene.surfaces[from].shape), area(scene.surfaces[to].shape));
    }
    pair.sampled.push_back(std::move(open.surfaces));
}

/// Adds known pairs of the same faces up.
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
    result.known = together(parts, &Seen::known);
    merge_same(result.known);
    std::vector<OpenPair> open = together(parts, &Seen::open);
    result.shot.resize(scene.surfaces.size());
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
        const bool is_partly_known = known != result.known.end() && std::pair(known->from, known->to) == faces;
        if (is_partly_known) add(pair, *known);
        for (; first < open.size() && std::pair(open[first].face, open[first].other_face) == faces; ++first) {
            const auto [from, to] = std::pair(open[first].surfaces.from, open[first].surfaces.to);
            result.shot[from].push_back(to);
            if (from != to) result.shot[to].push_back(from);
            add(pair, scene, std::move(open[first]));
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
            result.pairs.push_back(std::move(pair));
    }
    std::erase_if(result.known, [](const KnownPair& pair) { return pair.method == ExchangeMethod::none; });
    const auto middle = static_cast<std::ptrdiff_t>(result.known.size());
    result.known.insert(result.known.end(), small.begin(), small.end());
    std::inplace_merge(result.known.begin(), result.known.begin() + middle, result.known.end(), InOrder{});
    for (std::vector<std::uint32_t>& others : result.shot) std::sort(others.begin(), others.end());
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
    FacePairs result;
    result.areas.assign(scene.faces.size(), 0);
    result.dropped.resize(scene.faces.size());
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != no_face) result.areas[static_cast<std::size_t>(surface.face)] += area(surface.shape);
    }
    if (!is_each_looked_at(scene)) {
        leave_all_to_rays(result);
        add_resolution(scene, result);
        return result;
    }
    result.occluders = std::make_shared<const Occluders>(scene);
    add_up(scene, look_at_pairs(scene, result, request), request, result);
    for (FacePair& pair : result.pairs) {
        pair.by_cells = pair.sampled.size() <= most_pairs_by_cells &&
                        std::all_of(pair.sampled.begin(), pair.sampled.end(), [](const SampledPair& sampled) {
                            return sampled.exchange.method == ExchangeMethod::cells;
                        });
    }
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

#include "studies/form_factors/face_pairs.hpp"

#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "core/visibility/facing.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// All pairs of this many faces are looked at within an hour.
constexpr std::size_t most_faces = 32768;

/// Every pair of surfaces is looked at in scenes with at most this many surfaces, or with at most this many per face.
constexpr std::size_t most_surfaces = 4096;
constexpr std::size_t most_surfaces_per_face = 4;

bool is_each_looked_at(const Scene& scene) {
    return scene.surfaces.size() <= std::max(most_surfaces, most_surfaces_per_face * scene.faces.size());
}

/// Points are sampled for each pair of surfaces. Where two faces have more such pairs than this, rays are cheaper: they
/// serve all pairs at once.
constexpr std::size_t most_pairs_by_points = 256;

/// Where more pairs of faces than this have to be sampled, the effort for each depends on how much can pass between
/// them (PointEffort::sized).
constexpr std::size_t most_of_full_effort = 32;

/// Pairs whose bounds are this near to each other, in tolerances, are not sampled.
constexpr double near_enough = 0.5;

/// A surface pair adds to the pair of its faces.
void add(FacePair& pair, std::uint32_t from, std::uint32_t to, double times, PairExchange exchange, double largest) {
    pair.method = std::max(pair.method, exchange.method);
    pair.reason = std::max(pair.reason, exchange.reason);
    const auto& area = exchange.area;
    const bool sampled = exchange.method >= ExchangeMethod::points;
    if (area) pair.most += times * (area->value + area->error);
    if (sampled && !area) pair.all_unblocked_known = false;
    if (area) pair.bound += times * area->error;  // of sampled pairs it may be what the hidden part is taken off
    if (!sampled) {
        pair.known += times * area->value;
        return;
    }
    if (!area) pair.most += times * largest;
    pair.sampled.push_back({from, to, times, std::move(exchange)});
}

/// A surface that another exchanges something with, or may.
struct Partner {
    std::uint32_t to = 0;
    PairExchange exchange;
};

/// A pair that is dropped takes little room.
struct Dropped {
    std::uint32_t to = 0;
    float least = 0;
    float most = 0;
};

/// The surfaces that one surface exchanges something with.
struct Partners {
    std::vector<Partner> kept;
    std::vector<Dropped> dropped;
};

/// The least exchange area that is kept, for each surface. It is 0 for surfaces that share a face, whose exchange is
/// not known before it is added up.
std::vector<double> least_kept(const Scene& scene, double drop) {
    std::vector<std::size_t> surfaces(scene.faces.size(), 0);
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != no_face) ++surfaces[static_cast<std::size_t>(surface.face)];
    }
    std::vector<double> result;
    for (const Surface& surface : scene.surfaces) {
        const bool sole = surface.face != no_face && surfaces[static_cast<std::size_t>(surface.face)] == 1;
        result.push_back(sole ? drop * area(surface.shape) : 0);
    }
    return result;
}

/// The pair if it exchanges less than that, whatever stands in between.
std::optional<Dropped> dropped(std::size_t to, const PairExchange& exchange, double below) {
    if (!exchange.area || exchange.area->value + exchange.area->error >= below) return std::nullopt;
    // Rounded outwards.
    constexpr auto up = 1 + std::numeric_limits<float>::epsilon();
    const bool sampled = exchange.method >= ExchangeMethod::points;
    const double least = sampled ? 0 : std::max(0.0, exchange.area->value - exchange.area->error);
    return Dropped{static_cast<std::uint32_t>(to), static_cast<float>(least) / up,
                   static_cast<float>(exchange.area->value + exchange.area->error) * up};
}

/// Those of one surface among itself and the ones after it.
/// @param below  by surface: pairs that exchange less than this times the smaller area are dropped; 0: none
Partners partners_of(const Scene& scene, const SceneSight& sight, WallViews* views, std::size_t first, double wanted,
                     const std::vector<double>& below, const std::atomic<bool>* stop) {
    const PairExchange unknown{ExchangeMethod::rays, ExchangeReason::many_surfaces, std::nullopt, {}};
    Partners result;
    const Surface& from = scene.surfaces[first];
    for (std::size_t j = first; j < scene.surfaces.size(); ++j) {
        const Surface& to = scene.surfaces[j];
        if (from.face == no_face || to.face == no_face) continue;
        PairExchange exchange =
            stop != nullptr && *stop ? unknown : pair_exchange(scene, sight, first, j, wanted, views);
        if (exchange.method == ExchangeMethod::none) continue;
        const double least = j == first ? 0 : std::min(below[first], below[j]);
        if (const auto little = dropped(j, exchange, least))
            result.dropped.push_back(*little);
        else
            result.kept.push_back({static_cast<std::uint32_t>(j), std::move(exchange)});
    }
    return result;
}

/// Where bounds from geometry are as narrow as is asked for, takes their middle.
void settle(FacePair& pair, double wanted) {
    if (!pair.is_sampled() || !pair.all_unblocked_known) return;
    const double least = std::max(0.0, pair.known - pair.bound);
    if (pair.most - least > 2 * near_enough * wanted) return;
    pair.known = (least + pair.most) / 2;
    pair.bound = (pair.most - least) / 2;
    pair.sampled = {};
    pair.method = ExchangeMethod::bounds;
    pair.reason = ExchangeReason::small;
}

/// Coordinates of the scene are rounded like the largest of them. That shows where faces are small beside it.
void add_resolution(const Scene& scene, FacePairs& pairs) {
    constexpr double noticeable = 1e-9;
    const double step = 4 * std::numeric_limits<double>::epsilon() * farthest_coordinate(scene);
    for (FacePair& pair : pairs.pairs) {
        const double size = std::sqrt(std::min(pairs.areas[pair.from], pairs.areas[pair.to]));
        if (pair.is_sampled() && step > noticeable * size) pair.resolution = std::min(step, size) * size;
    }
}

void expect_few_faces(const Scene& scene) {
    const std::size_t most = is_each_looked_at(scene) ? most_faces : most_dense_faces;
    if (scene.faces.size() <= most) return;
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
            pair.method = ExchangeMethod::rays;
            pair.reason = ExchangeReason::many_surfaces;
            pair.most = std::min(result.areas[from], result.areas[to]);
        }
    }
}

/// Surfaces in parts of which each is of one wall, so that what is proved of the wall serves all of them.
std::vector<std::vector<std::size_t>> wall_parts(const Scene& scene, const SceneSight& sight) {
    constexpr std::size_t most_in_part = 32;  // there is work for many threads in few walls
    std::map<std::size_t, std::vector<std::size_t>> open;
    std::vector<std::vector<std::size_t>> parts;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        std::vector<std::size_t>& part = open[sight.occluders ? sight.occluders->wall_of(i) : i];
        part.push_back(i);
        if (part.size() == most_in_part) parts.push_back(std::exchange(part, {}));
    }
    for (auto& [wall, part] : open) {
        if (!part.empty()) parts.push_back(std::move(part));
    }
    return parts;
}

/// Looks at each pair of surfaces. @return by the first, of those that exchange anything
std::vector<Partners> look_at_pairs(const Scene& scene, const FacePairs& known, const Request& request) {
    const std::size_t n = scene.surfaces.size();
    const double smallest = *std::min_element(known.areas.begin(), known.areas.end());
    // Errors of all pairs of surfaces add up.
    const double wanted = request.tolerance * smallest / 8 / static_cast<double>(n);
    const std::vector<double> below = least_kept(scene, request.drop);
    std::vector<Partners> rows(n);
    std::mutex reporting;
    std::size_t looked_at = 0;
    const std::vector<std::vector<std::size_t>> parts = wall_parts(scene, known.sight);
    for_each_index(parts.size(), request.threads, [&](std::uint64_t part) {
        std::optional<WallViews> views;
        if (known.sight.occluders) views.emplace(*known.sight.occluders);
        std::size_t looked_at_here = 0;
        for (const std::size_t i : parts[part]) {
            rows[i] = partners_of(scene, known.sight, views ? &*views : nullptr, i, wanted, below, request.stop);
            looked_at_here += n - i;
        }
        if (!request.report) return;
        const std::lock_guard lock(reporting);
        looked_at += looked_at_here;
        const double share = static_cast<double>(looked_at) / (0.5 * static_cast<double>(n * (n + 1)));
        request.report({Progress::Stage::looking, 0, share, 0, 0, pairs_of(known.faces())});
    });
    return rows;
}

/// Sums what surfaces exchange over pairs of faces.
void add_up(const Scene& scene, std::vector<Partners> rows, FacePairs& result) {
    /// Two surfaces, and their faces in order.
    struct Entry {
        std::uint32_t face, other_face, from, at;
    };
    const std::size_t n = scene.surfaces.size();
    std::vector<Entry> entries;
    result.shot.assign(n * n, false);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto face = static_cast<std::uint32_t>(scene.surfaces[i].face);
        for (const Dropped& little : std::exchange(rows[i].dropped, {})) {
            const auto other = static_cast<std::uint32_t>(scene.surfaces[little.to].face);
            add_dropped(result.dropped, face, other, 0.5 * (little.least + little.most), little.least, little.most);
        }
        for (std::uint32_t k = 0; k < rows[i].kept.size(); ++k) {
            const auto other = static_cast<std::uint32_t>(scene.surfaces[rows[i].kept[k].to].face);
            entries.push_back({std::min(face, other), std::max(face, other), i, k});
        }
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::pair(a.face, a.other_face) < std::pair(b.face, b.other_face);
    });
    for (const Entry& entry : entries) {
        if (result.pairs.empty() || result.pairs.back().from != entry.face ||
            result.pairs.back().to != entry.other_face) {
            FacePair& pair = result.pairs.emplace_back();
            pair.from = entry.face;
            pair.to = entry.other_face;
        }
        auto& [to, exchange] = rows[entry.from].kept[entry.at];
        if (exchange.method >= ExchangeMethod::points)
            result.shot[entry.from * n + to] = result.shot[to * n + entry.from] = true;
        const double largest = std::min(area(scene.surfaces[entry.from].shape), area(scene.surfaces[to].shape));
        add(result.pairs.back(), entry.from, to, entry.face == entry.other_face && entry.from != to ? 2 : 1,
            std::move(exchange), largest);
    }
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
    result.sight = sight_of(scene);
    add_up(scene, look_at_pairs(scene, result, request), result);
    for (FacePair& pair : result.pairs) {
        const double smaller = std::min(result.areas[pair.from], result.areas[pair.to]);
        pair.most = std::min(pair.most, smaller);
        settle(pair, std::max(request.tolerance_between(pair.from, pair.to) * smaller,
                              request.relative * std::max(0.0, pair.known - pair.bound)));
        pair.by_points = !pair.sampled.empty() && pair.sampled.size() <= most_pairs_by_points &&
                         std::all_of(pair.sampled.begin(), pair.sampled.end(), [](const SampledPair& sampled) {
                             return sampled.exchange.method == ExchangeMethod::points;
                         });
    }
    const auto sampled =
        std::count_if(result.pairs.begin(), result.pairs.end(), [](const FacePair& pair) { return pair.is_sampled(); });
    if (static_cast<std::size_t>(sampled) > most_of_full_effort) result.effort = PointEffort::sized;
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
    for (FacePair& pair : pairs.pairs) {
        const double diagonal = std::min(diagonals[pair.from], diagonals[pair.to]);
        pair.resolution = std::max(pair.resolution, of_diagonals * rounding * diagonal);
    }
}

}  // namespace ff::studies::form_factors

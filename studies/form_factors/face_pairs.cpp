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
#include <mutex>
#include <optional>
#include <tuple>
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

/// Two surfaces that exchange something, or may.
struct SurfacePair {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    PairExchange exchange;
};

/// A pair that is dropped takes little room.
struct DroppedPair {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    float least = 0;
    float most = 0;
};

/// What was found in a visit.
struct Seen {
    std::vector<SurfacePair> kept;
    std::vector<DroppedPair> dropped;
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
std::optional<DroppedPair> dropped(std::uint32_t from, std::uint32_t to, const PairExchange& exchange, double below) {
    if (!exchange.area || exchange.area->value + exchange.area->error >= below) return std::nullopt;
    // Rounded outwards.
    constexpr auto up = 1 + std::numeric_limits<float>::epsilon();
    const bool sampled = exchange.method >= ExchangeMethod::points;
    const double least = sampled ? 0 : std::max(0.0, exchange.area->value - exchange.area->error);
    return DroppedPair{from, to, static_cast<float>(least) / up,
                       static_cast<float>(exchange.area->value + exchange.area->error) * up};
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

/// Looks at each pair of surfaces. @return what was found, part by part
std::vector<Seen> look_at_pairs(const Scene& scene, const FacePairs& known, const Request& request) {
    constexpr double most_in_part = 1 << 16;
    const auto n = static_cast<double>(scene.surfaces.size());
    const double smallest = *std::min_element(known.areas.begin(), known.areas.end());
    // Errors of all pairs of surfaces add up.
    const double wanted = request.tolerance * smallest / 8 / n;
    const std::vector<double> below = least_kept(scene, request.drop);
    const PairExchange unknown{ExchangeMethod::rays, ExchangeReason::many_surfaces, std::nullopt, {}};
    const std::vector<Occluders::Visit> visits = known.occluders->visits(most_in_part);
    std::vector<Seen> parts(visits.size());
    std::mutex reporting;
    double looked_at = 0;
    for_each_index(visits.size(), request.threads, [&](std::uint64_t v) {
        Seen& part = parts[v];
        known.occluders->see(visits[v], [&](std::uint32_t from, std::uint32_t to, const Occluders::Between& between) {
            const bool is_stopped = request.stop != nullptr && *request.stop;
            PairExchange exchange =
                is_stopped ? unknown : pair_exchange(scene.surfaces[from], scene.surfaces[to], between, wanted);
            const double least = from == to ? 0 : std::min(below[from], below[to]);
            if (const auto little = dropped(from, to, exchange, least))
                part.dropped.push_back(*little);
            else
                part.kept.push_back({from, to, std::move(exchange)});
        });
        if (!request.report) return;
        const std::lock_guard lock(reporting);
        looked_at += visits[v].pairs;
        const double share = std::min(1.0, looked_at / (0.5 * n * (n + 1)));
        request.report({Progress::Stage::looking, 0, share, 0, 0, pairs_of(known.faces())});
    });
    return parts;
}

/// Sums what surfaces exchange over pairs of faces.
void add_up(const Scene& scene, std::vector<Seen> parts, FacePairs& result) {
    /// Two faces in order, and their surfaces.
    struct Entry {
        std::uint32_t face, other_face;
        SurfacePair* pair;

        [[nodiscard]] auto place() const { return std::tuple(face, other_face, pair->from, pair->to); }
    };
    const auto face_of = [&](std::uint32_t surface) {
        return static_cast<std::uint32_t>(scene.surfaces[surface].face);
    };
    const std::size_t n = scene.surfaces.size();
    std::vector<Entry> entries;
    result.shot.assign(n * n, false);
    for (Seen& part : parts) {
        for (const DroppedPair& little : part.dropped) {
            add_dropped(result.dropped, face_of(little.from), face_of(little.to), 0.5 * (little.least + little.most),
                        little.least, little.most);
        }
        for (SurfacePair& pair : part.kept) {
            const auto [face, other] = std::minmax({face_of(pair.from), face_of(pair.to)});
            entries.push_back({face, other, &pair});
        }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.place() < b.place(); });
    for (const Entry& entry : entries) {
        if (result.pairs.empty() || result.pairs.back().from != entry.face ||
            result.pairs.back().to != entry.other_face) {
            FacePair& pair = result.pairs.emplace_back();
            pair.from = entry.face;
            pair.to = entry.other_face;
        }
        auto& [from, to, exchange] = *entry.pair;
        if (exchange.method >= ExchangeMethod::points) result.shot[from * n + to] = result.shot[to * n + from] = true;
        const double largest = std::min(area(scene.surfaces[from].shape), area(scene.surfaces[to].shape));
        add(result.pairs.back(), from, to, entry.face == entry.other_face && from != to ? 2 : 1, std::move(exchange),
            largest);
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
    result.occluders = std::make_shared<const Occluders>(scene);
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

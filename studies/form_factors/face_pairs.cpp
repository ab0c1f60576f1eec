#include "studies/form_factors/face_pairs.hpp"

#include "core/geometry/placement.hpp"
#include "core/support/error.hpp"
#include "core/visibility/facing.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace ff::studies {
namespace {

/// A matrix of more takes gigabytes.
constexpr std::size_t most_faces = 4096;

/// Of more surfaces not every pair is looked at.
constexpr std::size_t most_surfaces = 4096;

/// Points are sampled for each pair of surfaces; of more pairs, rays serve all at once.
constexpr std::size_t most_pairs_by_points = 256;

/// Of more pairs of faces to sample each is given points by what can pass.
constexpr std::size_t most_of_full_effort = 512;

/// Pairs whose bounds are this near to each other, in tolerances, are not sampled.
constexpr double near_enough = 0.5;

/// A surface pair adds to the pair of its faces.
void add(FacePair& pair, std::uint32_t from, std::uint32_t to, double times, PairExchange exchange, double largest) {
    ++pair.methods[static_cast<std::size_t>(exchange.method)];
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

/// Pairs of one surface with those after it.
std::vector<PairExchange> exchanges_of(const Scene& scene, const SceneSight& sight, std::size_t first, double wanted,
                                       const std::atomic<bool>* stop) {
    const PairExchange unknown{ExchangeMethod::rays, ExchangeReason::many_surfaces, std::nullopt, {}};
    std::vector<PairExchange> result;
    const Surface& from = scene.surfaces[first];
    for (std::size_t j = first; j < scene.surfaces.size(); ++j) {
        const Surface& to = scene.surfaces[j];
        const bool counts = from.face != no_face && to.face != no_face;
        if (!counts)
            result.emplace_back();
        else
            result.push_back(stop != nullptr && *stop ? unknown : pair_exchange(scene, sight, first, j, wanted));
    }
    return result;
}

/// Takes the middle of what geometry bounds where that is all that is asked for.
void settle(FacePair& pair, double wanted) {
    if (!pair.is_sampled() || !pair.all_unblocked_known) return;
    const double least = std::max(0.0, pair.known - pair.bound);
    if (pair.most - least > 2 * near_enough * wanted) return;
    pair.known = (least + pair.most) / 2;
    pair.bound = (pair.most - least) / 2;
    pair.sampled.clear();
    pair.methods = {};
    pair.methods[static_cast<std::size_t>(ExchangeMethod::bounds)] = 1;
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
    if (scene.faces.size() <= most_faces) return;
    throw UserError(fmt::format("scene '{}': {} faces (a matrix of at most {} is made). Put surfaces into groups.",
                                scene.name, scene.faces.size(), most_faces));
}

}  // namespace

std::size_t pair_index(std::size_t a, std::size_t b, std::size_t faces) {
    const auto [from, to] = std::minmax(a, b);
    return from * faces - from * (from + 1) / 2 + to;
}

FacePairs examine_pairs(const Scene& scene, const FormFactorRequest& request) {
    expect_few_faces(scene);
    FacePairs result;
    result.areas.assign(scene.faces.size(), 0);
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != no_face) result.areas[static_cast<std::size_t>(surface.face)] += area(surface.shape);
    }
    for (std::size_t from = 0; from < result.faces(); ++from) {
        for (std::size_t to = from; to < result.faces(); ++to) {
            FacePair pair;
            pair.from = from;
            pair.to = to;
            result.pairs.push_back(std::move(pair));
        }
    }
    const auto at_most_all = [&](FacePair& pair) {
        pair.most = std::min(pair.most, std::min(result.areas[pair.from], result.areas[pair.to]));
    };
    const std::size_t n = scene.surfaces.size();
    if (n > most_surfaces) {
        for (FacePair& pair : result.pairs) {
            pair.everything = true;
            pair.all_unblocked_known = false;
            pair.reason = ExchangeReason::many_surfaces;
            pair.most = std::min(result.areas[pair.from], result.areas[pair.to]);
            pair.methods[static_cast<std::size_t>(ExchangeMethod::rays)] = 1;
        }
        add_resolution(scene, result);
        return result;
    }
    result.sight = sight_of(scene);
    const double smallest = *std::min_element(result.areas.begin(), result.areas.end());
    std::vector<std::vector<PairExchange>> rows(n);
    // Errors of all pairs of surfaces add up.
    const double wanted = request.tolerance * smallest / 8 / static_cast<double>(n);
    std::mutex reporting;
    std::size_t looked_at = 0;
    for_each_index(n, request.threads, [&](std::uint64_t i) {
        rows[i] = exchanges_of(scene, result.sight, i, wanted, request.stop);
        if (!request.report) return;
        const std::lock_guard lock(reporting);
        looked_at += n - i;
        const double share = static_cast<double>(looked_at) / (0.5 * static_cast<double>(n * (n + 1)));
        request.report({FormFactorProgress::Stage::looking, 0, share, 0, 0, result.pairs.size()});
    });

    result.shot.assign(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        const int from = scene.surfaces[i].face;
        for (std::size_t j = i; j < n; ++j) {
            const int to = scene.surfaces[j].face;
            if (from == no_face || to == no_face) continue;
            FacePair& pair = result.pairs[result.index(static_cast<std::size_t>(from), static_cast<std::size_t>(to))];
            PairExchange& exchange = rows[i][j - i];
            if (exchange.method >= ExchangeMethod::points) result.shot[i * n + j] = result.shot[j * n + i] = 1;
            const double largest = std::min(area(scene.surfaces[i].shape), area(scene.surfaces[j].shape));
            add(pair, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), from == to && i != j ? 2 : 1,
                std::move(exchange), largest);
        }
        rows[i].clear();
    }
    for (FacePair& pair : result.pairs) {
        at_most_all(pair);
        settle(pair, request.tolerance * std::min(result.areas[pair.from], result.areas[pair.to]));
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

}  // namespace ff::studies

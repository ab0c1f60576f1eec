#include "studies/form_factors/surface_pairs.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/face_pairs.hpp"
#include "studies/run/parallel.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

namespace ff::studies::form_factors {
namespace {

constexpr std::uint32_t faced_ends = 3;

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

/// The pair, if it exchanges less than that whatever stands in between.
std::optional<DroppedPair> dropped(std::uint32_t from, std::uint32_t to, const PairExchange& exchange, double below) {
    if (!exchange.area || exchange.area->value + exchange.area->error >= below) return std::nullopt;
    // Rounded outwards.
    constexpr auto up = 1 + std::numeric_limits<float>::epsilon();
    const bool sampled = exchange.method >= ExchangeMethod::cells;
    const double least = sampled ? 0 : std::max(0.0, exchange.area->value - exchange.area->error);
    return DroppedPair{from, to, static_cast<float>(least) / up,
                       static_cast<float>(exchange.area->value + exchange.area->error) * up};
}

/// Pairs that there was no time to examine are kept as unknown, unless there are too many.
void expect_few_unknown(const Scene& scene) {
    if (scene.faces.size() <= most_dense_faces) return;
    throw InterruptedError(
        "scene '{}': stopped while looking at what its {} faces see of each other (nothing was sampled, and nothing is "
        "written). Allow more time or memory, or see --dry-run.",
        scene.name, scene.faces.size());
}

}  // namespace

void SampledPairs::add(std::uint32_t face, std::uint32_t other_face, std::uint32_t from, std::uint32_t to,
                       const PairExchange& exchange) {
    FF_EXPECT(exchange.blockers.size() <= std::numeric_limits<std::uint16_t>::max());
    const auto first = static_cast<std::uint32_t>(blockers_.size());
    for (const Blocker& blocker : exchange.blockers) {
        const auto wall = static_cast<std::uint32_t>(blocker.surface - walls_.data());
        blockers_.push_back(wall * faced_ends + static_cast<std::uint32_t>(blocker.faces));
    }
    constexpr double unknown = std::numeric_limits<double>::infinity();
    pairs_.push_back({face, other_face, from, to, first, static_cast<std::uint16_t>(exchange.blockers.size()),
                      exchange.reason, exchange.method, exchange.area.value_or(BoundedValue<double>{unknown, 0})});
}

void SampledPairs::add(const SampledPair& pair, const SampledPairs& others) {
    pairs_.push_back(pair);
    pairs_.back().first_blocker = static_cast<std::uint32_t>(blockers_.size());
    const auto blockers = std::span(others.blockers_).subspan(pair.first_blocker, pair.blockers);
    blockers_.insert(blockers_.end(), blockers.begin(), blockers.end());
}

void SampledPairs::reserve(std::size_t pairs, std::size_t blockers) {
    pairs_.reserve(pairs);
    blockers_.reserve(blockers);
}

void SampledPairs::sort() {
    const auto place = [](const SampledPair& pair) {
        return std::tuple(pair.face, pair.other_face, pair.from, pair.to);
    };
    std::sort(pairs_.begin(), pairs_.end(),
              [&](const SampledPair& a, const SampledPair& b) { return place(a) < place(b); });
}

void SampledPairs::shrink_to_fit() {
    pairs_.shrink_to_fit();
    blockers_.shrink_to_fit();
}

PairExchange SampledPairs::exchange(const SampledPair& pair) const {
    PairExchange result;
    result.method = pair.method;
    result.reason = pair.reason;
    result.area = pair.is_whole_known() ? std::optional(pair.whole) : std::nullopt;
    for (const std::uint32_t blocker : std::span(blockers_).subspan(pair.first_blocker, pair.blockers))
        result.blockers.emplace_back(&walls_[blocker / faced_ends], static_cast<FacedEnd>(blocker % faced_ends));
    return result;
}

std::vector<Seen> look_at_pairs(const Scene& scene, const std::vector<double>& areas, const Occluders& occluders,
                                const Request& request) {
    constexpr double most_in_part = 1 << 16;
    const auto n = static_cast<double>(scene.surfaces.size());
    const double smallest = *std::min_element(areas.begin(), areas.end());
    // Errors of all pairs of surfaces add up.
    const double wanted = request.tolerance * smallest / 8 / n;
    const std::vector<double> below = least_kept(scene, request.drop);
    const PairExchange unknown{ExchangeMethod::rays, ExchangeReason::many_surfaces, std::nullopt, {}};
    const std::vector<Occluders::Visit> visits = occluders.visits(most_in_part);
    std::vector<Seen> parts(visits.size(), Seen{{}, SampledPairs(occluders), {}});
    std::mutex reporting;
    double looked_at = 0;
    for_each_index(visits.size(), request.threads, [&](std::uint64_t v) {
        Seen& part = parts[v];
        const auto see = [&](std::uint32_t from, std::uint32_t to, const Occluders::Between& between) {
            const bool is_stopped = request.stop != nullptr && *request.stop;
            if (is_stopped) expect_few_unknown(scene);
            const Surface& first = scene.surfaces[from];
            const Surface& second = scene.surfaces[to];
            const PairExchange exchange = is_stopped ? unknown : pair_exchange(first, second, between, wanted);
            if (const auto little = dropped(from, to, exchange, from == to ? 0 : std::min(below[from], below[to]))) {
                part.dropped.push_back(*little);
                return;
            }
            const auto [face, other] = std::minmax({first.face, second.face});
            const auto a = static_cast<std::uint32_t>(face);
            const auto b = static_cast<std::uint32_t>(other);
            const double times = a == b && from != to ? 2 : 1;
            if (exchange.method >= ExchangeMethod::cells)
                part.open.add(a, b, from, to, exchange);
            else
                part.known.push_back({a, b, times * exchange.area->value, times * exchange.area->error, exchange.method,
                                      exchange.reason});
        };
        occluders.see(visits[v], see);
        part.known.shrink_to_fit();
        part.open.shrink_to_fit();
        if (!request.report) return;
        const std::lock_guard lock(reporting);
        looked_at += visits[v].pairs;
        const double share = std::min(1.0, looked_at / (0.5 * n * (n + 1)));
        request.report({Progress::Stage::looking, 0, share, 0, 0, pairs_of(areas.size())});
    });
    return parts;
}

}  // namespace ff::studies::form_factors

#include "studies/form_factors/row_by_rays.hpp"

#include "samplers/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// How fast half widths fall, at least: slower than measured on whole scenes (docs/convergence.md), so that a round
/// seldom misses.
constexpr double usual_rate = 0.6;
constexpr double rate_of_rare = 0.5;

/// A standard deviation of 16 values is at most this factor too small in nine of ten cases: sqrt(15 / chi^2(15, 0.1)).
constexpr double margin = 1.33;

/// A sequence has at most 2^32 points.
constexpr double most_points_of_sequence = 0x1p31;

/// Half widths are assumed to fall at `rate_of_rare` with fewer hits or misses than this.
constexpr std::uint64_t few = 100;

double rate_of_hits(const SampledShare& share) {
    if (share.met == 0 || share.met == share.points) return 1;
    return std::min(share.met, share.points - share.met) < few ? rate_of_rare : usual_rate;
}

/// Rays of a randomisation for which the half width falls from `now` to `wanted`.
std::uint64_t rays_for_width(std::uint64_t rays, double now, double wanted, double rate) {
    if (!(now > 0)) return rays;
    if (!(wanted > 0)) return static_cast<std::uint64_t>(most_points_of_sequence);
    const double doublings = std::ceil(std::log2(now / wanted) / rate);
    return static_cast<std::uint64_t>(
        std::min(most_points_of_sequence, static_cast<double>(rays) * std::exp2(doublings)));
}

constexpr std::uint32_t not_wanted = std::numeric_limits<std::uint32_t>::max();

}  // namespace

bool RowByRays::is_shot(std::uint32_t from, std::uint32_t to) const {
    if (geometry_->shot.empty()) return true;
    const std::vector<std::uint32_t>& others = geometry_->shot[from];
    return std::binary_search(others.begin(), others.end(), to);
}

std::vector<std::uint32_t> RowByRays::pairs_of_faces() const {
    std::vector<std::uint32_t> result(scene_->faces.size(), not_wanted);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const FacePair& faces = geometry_->pairs[pairs_[k]];
        result[faces.from == from_ ? faces.to : faces.from] = static_cast<std::uint32_t>(k);
    }
    return result;
}

RowByRays::RowByRays(const Scene& scene, const FacePairs& geometry, std::size_t from, std::vector<std::size_t> pairs)
    : scene_(&scene), geometry_(&geometry), from_(from), pairs_(std::move(pairs)), hits_(randomisations) {
    const std::vector<std::uint32_t> pair_of_face = pairs_of_faces();
    const auto n = static_cast<std::uint32_t>(scene.surfaces.size());
    const auto is_wanted = [&](std::uint32_t surface) {
        const int face = scene.surfaces[surface].face;
        return face != no_face && pair_of_face[static_cast<std::size_t>(face)] != not_wanted;
    };
    for (std::uint32_t s = 0; s < n; ++s) {
        if (scene.surfaces[s].face != static_cast<int>(from)) continue;
        if (!geometry.shot.empty() && std::none_of(geometry.shot[s].begin(), geometry.shot[s].end(), is_wanted))
            continue;
        sources_.push_back({s, 0});
        source_area_ += area(scene.surfaces[s].shape);
    }
    double before = 0;
    for (Source& source : sources_) {
        source.first = static_cast<std::uint64_t>(before / source_area_ * 0x1p32);
        before += area(scene.surfaces[source.surface].shape);
    }
    sources_.push_back({no_surface, std::uint64_t{1} << 32});
}

void RowByRays::run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, const std::atomic<bool>* stop) {
    const auto sampler = samplers::house_sampler().make({.points = rays_, .dimension = 4});
    const Stream stream{.key = key, .trial = randomisation, .source = static_cast<std::uint32_t>(from_)};
    const auto block = std::make_unique<PointBlock>();
    const auto part = std::make_unique<PointBlock>();
    const std::vector<std::uint32_t> pair_of_face = pairs_of_faces();
    std::vector<Hit> found(block_capacity);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // source, point
    Hits result{std::vector<std::uint64_t>(pairs_.size()), 0};

    const auto shoot = [&](std::uint32_t surface, const PointBlock& points) {
        const std::span<Hit> hits(found.data(), points.size);
        tracer.find_ends(scene_->surfaces[surface], surface, undivided, 0, points, hits);
        for (const Hit& hit : hits) {
            if (hit.surface == no_surface) {
                ++result.lost;
            } else if (hit.received && is_shot(surface, hit.surface)) {
                const auto face = static_cast<std::size_t>(scene_->surfaces[hit.surface].face);
                if (pair_of_face[face] != not_wanted) ++result.hits[pair_of_face[face]];
            }
        }
    };
    for (std::uint64_t first = 0; first < rays_; first += block->size) {
        expect_more_time(stop);
        block->size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, rays_ - first));
        sampler->fill(stream, first, *block);
        if (sources_.size() == 2) {
            shoot(sources_.front().surface, *block);
            continue;
        }
        order.clear();
        for (std::uint32_t i = 0; i < block->size; ++i) {
            const auto after = std::upper_bound(sources_.begin(), sources_.end(), block->coordinate[0][i],
                                                [](std::uint64_t u, const Source& s) { return u < s.first; });
            order.emplace_back(static_cast<std::uint32_t>(after - sources_.begin() - 1), i);
        }
        std::sort(order.begin(), order.end());
        for (std::size_t begin = 0; begin < order.size();) {
            const std::uint32_t source = order[begin].first;
            const std::uint64_t low = sources_[source].first;
            const std::uint64_t share = sources_[source + 1].first - low;
            part->size = 0;
            std::size_t at = begin;
            for (; at < order.size() && order[at].first == source; ++at) {
                const std::uint32_t i = order[at].second;
                // Stretched over [0, 1); what lies below the last bit is its middle.
                part->coordinate[0][part->size] = static_cast<std::uint32_t>(
                    (((block->coordinate[0][i] - low) << 32) + (std::uint64_t{1} << 31)) / share);
                for (std::size_t d = 1; d < 4; ++d) part->coordinate[d][part->size] = block->coordinate[d][i];
                ++part->size;
            }
            shoot(sources_[source].surface, *part);
            begin = at;
        }
    }
    hits_[randomisation] = std::move(result);
}

SampledSum RowByRays::sum(std::size_t pair) const {
    SampledSum sum{geometry_->pairs[pair].known, {}};
    const auto t = static_cast<std::size_t>(std::find(pairs_.begin(), pairs_.end(), pair) - pairs_.begin());
    SampledShare share{{}, randomisations * rays_, {}, true, 0};
    for (const Hits& hits : hits_) {
        share.means.push_back(static_cast<double>(hits.hits[t]) / static_cast<double>(rays_));
        share.met += hits.hits[t];
    }
    sum.terms.push_back({source_area_, std::move(share)});
    return sum;
}

std::uint64_t RowByRays::rays_for(const std::vector<double>& wanted, double level) const {
    std::uint64_t most = least_rays;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const SampledSum sum = this->sum(pairs_[k]);
        const double now = margin * estimate_of(sum, level).half_width();
        most = std::max(most, rays_for_width(rays_, now, wanted[k], rate_of_hits(sum.terms.front().share)));
    }
    return most;
}

std::uint64_t RowByRays::lost() const {
    std::uint64_t sum = 0;
    for (const Hits& hits : hits_) sum += hits.lost;
    return sum;
}

}  // namespace ff::studies::form_factors

#include "studies/form_factors/row_by_rays.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// How fast half widths fall, at least: slower than measured on whole scenes (docs/convergence.md), so that a round
/// seldom misses.
constexpr double usual_rate = 0.6;
constexpr double rate_of_rare = 0.5;

/// A standard deviation of 16 values is at most so much too small, but once in ten times: sqrt(15 / chi^2(15, 0.1)).
constexpr double margin = 1.33;

/// A sequence has at most 2^32 points.
constexpr double most_points_of_sequence = 0x1p31;

/// With fewer hits than this, or fewer misses, half widths are taken to fall at `rate_of_rare`.
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

/// The other faces of these pairs.
std::vector<std::size_t> targets(const FacePairs& geometry, std::size_t from, const std::vector<std::size_t>& pairs) {
    std::vector<std::size_t> result;
    for (const std::size_t pair : pairs) {
        const FacePair& faces = geometry.pairs[pair];
        result.push_back(faces.from == from ? faces.to : faces.from);
    }
    return result;
}

}  // namespace

RowByRays::RowByRays(const Scene& scene, const FacePairs& geometry, std::size_t from, std::vector<std::size_t> pairs)
    : geometry_(&geometry),
      pairs_(std::move(pairs)),
      sampling_(scene, geometry, from, targets(geometry, from, pairs_)),
      hits_(randomisations) {}

void RowByRays::run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, const std::atomic<bool>* stop) {
    hits_[randomisation] = sampling_.run(tracer, key, randomisation, rays_, stop);
}

SampledSum RowByRays::sum(std::size_t pair) const {
    SampledSum sum{geometry_->pairs[pair].known, {}};
    const auto t = static_cast<std::size_t>(std::find(pairs_.begin(), pairs_.end(), pair) - pairs_.begin());
    SampledShare share{{}, randomisations * rays_, {}, true, 0};
    for (const RaySampling::Hits& hits : hits_) {
        share.means.push_back(static_cast<double>(hits.hits[t]) / static_cast<double>(rays_));
        share.met += hits.hits[t];
    }
    sum.terms.push_back({sampling_.source_area(), std::move(share)});
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
    for (const RaySampling::Hits& hits : hits_) sum += hits.lost;
    return sum;
}

}  // namespace ff::studies::form_factors

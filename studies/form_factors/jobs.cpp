#include "studies/form_factors/jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ff::studies {
namespace {

constexpr std::uint64_t least_points = 256;
constexpr std::uint64_t least_rays = 4096;

/// How fast half widths fall, at least: slower than measured on whole scenes (docs/convergence.md), so that a round
/// seldom misses.
constexpr double rate_of_points = 0.75;
constexpr double rate_of_rays = 0.6;
constexpr double rate_of_rare = 0.5;

/// A standard deviation of 16 values is at most so much too small, but once in ten times: sqrt(15 / chi^2(15, 0.1)).
constexpr double margin = 1.33;

/// A sequence has at most 2^32 points.
constexpr double most_points = 0x1p31;

double rate_of(const SampledShare& share, double usual) {
    if (!is_rare(share)) return usual;
    return share.met == 0 ? 1 : rate_of_rare;
}

}  // namespace

std::uint64_t size_for(std::uint64_t points, double now, double wanted, double rate) {
    if (!(now > 0)) return points;
    if (!(wanted > 0)) return static_cast<std::uint64_t>(most_points);
    const double doublings = std::ceil(std::log2(now / wanted) / rate);
    return static_cast<std::uint64_t>(std::min(most_points, static_cast<double>(points) * std::exp2(doublings)));
}

Job::Job(const Scene& scene, const FacePairs& pairs, std::size_t pair)
    : scene_(&scene), geometry_(&pairs), pairs_{pair}, point_sums_(randomisations) {
    for (const SampledPair& sampled : pairs.pairs[pair].sampled) points_.emplace_back(scene, sampled);
    hidden_.assign(points_.size(), false);
    sizes_.assign(points_.size(), least_points);
}

Job::Job(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> row)
    : scene_(&scene), geometry_(&pairs), pairs_(std::move(row)), sizes_{least_rays}, ray_hits_(randomisations) {
    std::vector<std::size_t> targets;
    for (const std::size_t pair : pairs_) {
        const FacePair& faces = pairs.pairs[pair];
        targets.push_back(faces.from == from ? faces.to : faces.from);
    }
    rays_.emplace(scene, pairs, from, std::move(targets));
}

std::uint64_t Job::samples() const {
    return randomisations * std::accumulate(sizes_.begin(), sizes_.end(), std::uint64_t{0});
}

double Job::cost(const std::vector<std::uint64_t>& sizes) const {
    if (rays_) return static_cast<double>(randomisations * sizes.front());
    double sum = 0;
    const auto& sampled = geometry_->pairs[pairs_.front()].sampled;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        // Measured: benchmarks/README.md.
        const double of_point = 10 + 3 * static_cast<double>(sampled[k].exchange.blockers.size());
        sum += of_point * static_cast<double>(randomisations * sizes[k]);
    }
    return sum;
}

void Job::halve() {
    const std::uint64_t least = rays_ ? least_rays : least_points;
    for (std::uint64_t& size : sizes_) size = std::max(least, size / 2);
}

bool Job::is_least() const {
    const std::uint64_t least = rays_ ? least_rays : least_points;
    return std::all_of(sizes_.begin(), sizes_.end(), [&](std::uint64_t size) { return size <= least; });
}

void Job::run(const Tracer* tracer, Seed seed, const std::string& round, std::uint32_t randomisation,
              const std::atomic<bool>* stop) {
    const StreamKey key = derive_key(
        seed, fmt::format("form factors of {}, {}, {}", scene_->canonical, rays_ ? "rays" : "points", round));
    if (rays_) {
        ray_hits_[randomisation] = rays_->run(*tracer, key, randomisation, sizes_.front(), stop);
        return;
    }
    std::vector<PointSums> sums;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        sums.push_back(points_[k].run(key, randomisation, sizes_[k], stop));
    }
    point_sums_[randomisation] = std::move(sums);
}

SampledShare Job::point_share(std::size_t k, bool hidden) const {
    SampledShare share{{}, randomisations * sizes_[k], 0, false};
    for (const auto& sums : point_sums_) {
        share.means.push_back(hidden ? sums[k].hidden : sums[k].visible);
        share.met += hidden ? sums[k].missed : sums[k].saw;
    }
    return share;
}

SampledSum::Term Job::point_term(std::size_t k) const {
    const double times = geometry_->pairs[pairs_.front()].sampled[k].times;
    return {(hidden_[k] ? -1 : 1) * times * points_[k].source_area(), point_share(k, hidden_[k])};
}

void Job::choose_sides() {
    for (std::size_t k = 0; k < points_.size(); ++k) {
        if (!geometry_->pairs[pairs_.front()].sampled[k].exchange.area) continue;
        const auto width = [&](bool hidden) {
            return estimate_of({0, {{1, point_share(k, hidden)}}}, 0.95).half_width();
        };
        hidden_[k] = width(true) < width(false);
    }
}

SampledSum Job::sum(std::size_t pair) const {
    const FacePair& faces = geometry_->pairs[pair];
    SampledSum sum{faces.known, {}};
    if (!rays_) {
        for (std::size_t k = 0; k < points_.size(); ++k) {
            if (hidden_[k]) sum.offset += faces.sampled[k].times * faces.sampled[k].exchange.area->value;
            sum.terms.push_back(point_term(k));
        }
        return sum;
    }
    const auto t = static_cast<std::size_t>(std::find(pairs_.begin(), pairs_.end(), pair) - pairs_.begin());
    SampledShare share{{}, randomisations * sizes_.front(), 0, true};
    for (const RaySampling::Hits& hits : ray_hits_) {
        share.means.push_back(static_cast<double>(hits.hits[t]) / static_cast<double>(sizes_.front()));
        share.met += hits.hits[t];
    }
    sum.terms.push_back({rays_->source_area(), std::move(share)});
    return sum;
}

std::uint64_t Job::rays_for(std::size_t k, double wanted, double level) const {
    const SampledSum sum = this->sum(pairs_[k]);
    const double now = margin * estimate_of(sum, level).half_width();
    return size_for(sizes_.front(), now, wanted, rate_of(sum.terms.front().share, rate_of_rays));
}

std::vector<std::uint64_t> Job::sizes_for(const std::vector<double>& wanted, double level) const {
    if (rays_) {
        std::uint64_t size = least_rays;
        for (std::size_t t = 0; t < pairs_.size(); ++t) size = std::max(size, rays_for(t, wanted[t], level));
        return {size};
    }
    // The widest terms are brought down to a common width, and the others are left as they are.
    std::vector<double> widths;
    std::vector<double> rates;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const SampledSum::Term term = point_term(k);
        widths.push_back(margin * estimate_of({0, {term}}, level).half_width());
        rates.push_back(rate_of(term.share, rate_of_points));
    }
    const auto together = [&](double cap) {
        double squares = 0;
        double rare = 0;
        for (std::size_t k = 0; k < widths.size(); ++k) {
            const double width = std::min(cap, widths[k]);
            (rates[k] == rate_of_points ? squares : rare) += rates[k] == rate_of_points ? width * width : width;
        }
        return std::sqrt(squares) + rare;
    };
    double cap = *std::max_element(widths.begin(), widths.end());
    for (int step = 0; step < 200 && together(cap) > wanted.front(); ++step) cap *= 0.9;
    std::vector<std::uint64_t> sizes;
    for (std::size_t k = 0; k < widths.size(); ++k)
        sizes.push_back(size_for(sizes_[k], widths[k], std::min(cap, widths[k]), rates[k]));
    return sizes;
}

std::uint64_t Job::lost() const {
    std::uint64_t sum = 0;
    for (const RaySampling::Hits& hits : ray_hits_) sum += hits.lost;
    return sum;
}

}  // namespace ff::studies

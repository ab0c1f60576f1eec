#include "studies/form_factors/jobs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace ff::studies::form_factors {
namespace {

/// Points of the first round: half as many as an exchange area has tolerances, in all randomisations, but of a large
/// one, or one that is not known, no fewer than most_first_points each.
constexpr std::uint64_t least_first_points = 4;
constexpr std::uint64_t most_first_points = 256;

/// How fast half widths fall, at least: slower than measured on whole scenes (docs/convergence.md), so that a round
/// seldom misses.
constexpr double rate_of_points = 0.75;
constexpr double rate_of_rays = 0.6;
constexpr double rate_of_rare = 0.5;

/// A standard deviation of 16 values is at most so much too small, but once in ten times: sqrt(15 / chi^2(15, 0.1)).
constexpr double margin = 1.33;

/// A sequence has at most 2^32 points.
constexpr double most_points_of_sequence = 0x1p31;

/// With fewer hits than this, or fewer misses, half widths are taken to fall at `rate_of_rare`.
constexpr std::uint64_t few = 100;

std::uint64_t first_points(const SampledPair& pair, double wanted) {
    std::uint64_t points = most_first_points;
    if (!pair.exchange.area || !(wanted > 0)) return points;
    const double enough = pair.exchange.area->value * pair.times / wanted / 2 / randomisations;
    while (points > least_first_points && static_cast<double>(points) / 2 >= enough) points /= 2;
    return points;
}

std::vector<std::uint64_t> first_sizes(const FacePairs& pairs, std::size_t pair, double wanted) {
    std::vector<std::uint64_t> sizes;
    for (const SampledPair& sampled : pairs.pairs[pair].sampled)
        sizes.push_back(pairs.effort == PointEffort::sized ? first_points(sampled, wanted) : most_first_points);
    return sizes;
}

double rate_of_hits(const SampledShare& share) {
    if (share.met == 0 || share.met == share.points) return 1;
    return std::min(share.met, share.points - share.met) < few ? rate_of_rare : rate_of_rays;
}

}  // namespace

std::uint64_t size_for(std::uint64_t points, double now, double wanted, double rate) {
    if (!(now > 0)) return points;
    if (!(wanted > 0)) return static_cast<std::uint64_t>(most_points_of_sequence);
    const double doublings = std::ceil(std::log2(now / wanted) / rate);
    return static_cast<std::uint64_t>(
        std::min(most_points_of_sequence, static_cast<double>(points) * std::exp2(doublings)));
}

Job::Job(const Scene& scene, const FacePairs& pairs, std::size_t pair, double wanted)
    : geometry_(&pairs),
      pairs_{pair},
      hidden_(pairs.pairs[pair].sampled.size(), false),
      sizes_(first_sizes(pairs, pair, wanted)),
      least_sizes_(sizes_),
      point_sums_(sizes_.size() * randomisations) {
    for (const SampledPair& sampled : pairs.pairs[pair].sampled)
        points_.emplace_back(scene, sampled, wanted / sampled.times, pairs.effort);
}

Job::Job(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> row)
    : geometry_(&pairs),
      pairs_(std::move(row)),
      cost_of_ray_(cost_of_ray(scene)),
      sizes_{least_rays},
      least_sizes_{least_rays},
      ray_hits_(randomisations) {
    std::vector<std::size_t> targets;
    for (const std::size_t pair : pairs_) {
        const FacePair& faces = pairs.pairs[pair];
        targets.push_back(faces.from == from ? faces.to : faces.from);
    }
    rays_.emplace(scene, pairs, from, std::move(targets));
}

std::uint64_t Job::samples() const {
    if (rays_) return randomisations * sizes_.front();
    double sum = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) sum += points_[k].evaluations() * static_cast<double>(sizes_[k]);
    return randomisations * static_cast<std::uint64_t>(sum);
}

double Job::cost(const std::vector<std::uint64_t>& sizes) const {
    if (rays_) return cost_of_ray_ * static_cast<double>(randomisations * sizes.front());
    double sum = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        sum += points_[k].cost() * static_cast<double>(randomisations * sizes[k]);
    }
    return sum;
}

void Job::halve() {
    for (std::size_t k = 0; k < sizes_.size(); ++k) sizes_[k] = std::max(least_sizes_[k], sizes_[k] / 2);
}

bool Job::is_least() const {
    return std::equal(sizes_.begin(), sizes_.end(), least_sizes_.begin(), std::less_equal<>());
}

void Job::run(const Tracer* tracer, StreamKey key, std::uint32_t first, std::uint32_t count,
              const std::atomic<bool>* stop) {
    if (rays_) {
        for (std::uint32_t r = first; r < first + count; ++r)
            ray_hits_[r] = rays_->run(*tracer, key, r, sizes_.front(), stop);
        return;
    }
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const std::span<PointSums> own(point_sums_.data() + k * randomisations, randomisations);
        points_[k].run(key, first, sizes_[k], stop, own.subspan(first, count));
    }
}

SampledSum Job::point_sum(std::size_t k, bool hidden) const {
    const double times = geometry_->pairs[pairs_.front()].sampled[k].times;
    const PointSampling::Side side = points_[k].side(hidden);
    SampledShare share{{}, randomisations * sizes_[k], side.unmet, false, 0};
    for (std::size_t r = 0; r < randomisations; ++r) {
        const PointSums& sums = point_sums_[k * randomisations + r];
        share.means.push_back(hidden ? sums.hidden : sums.visible);
    }
    return {times * side.known.value, {{times * side.sign, std::move(share)}}, times * side.known.error};
}

void Job::choose_sides() {
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const auto width = [&](bool hidden) { return estimate_of(point_sum(k, hidden), 0.95).half_width(); };
        hidden_[k] = points_[k].has_sides() && width(true) < width(false);
    }
}

SampledSum Job::sum(std::size_t pair) const {
    const FacePair& faces = geometry_->pairs[pair];
    SampledSum sum{faces.known, {}};
    if (!rays_) {
        for (std::size_t k = 0; k < points_.size(); ++k) {
            SampledSum part = point_sum(k, hidden_[k]);
            sum.offset += part.offset;
            sum.offset_error += part.offset_error;
            sum.terms.push_back(std::move(part.terms.front()));
        }
        return sum;
    }
    const auto t = static_cast<std::size_t>(std::find(pairs_.begin(), pairs_.end(), pair) - pairs_.begin());
    SampledShare share{{}, randomisations * sizes_.front(), {}, true, 0};
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
    return size_for(sizes_.front(), now, wanted, rate_of_hits(sum.terms.front().share));
}

std::vector<std::uint64_t> Job::sizes_for(const std::vector<double>& wanted, double level) const {
    if (rays_) {
        std::uint64_t size = least_rays;
        for (std::size_t t = 0; t < pairs_.size(); ++t) size = std::max(size, rays_for(t, wanted[t], level));
        return {size};
    }
    // The widest terms are brought down to a common width, and the others are left as they are.
    struct Term {
        double spread = 0;
        double scale = 0;
        UnmetBound unmet;
        std::uint64_t size = 0;
        double unmet_now = 0;

        [[nodiscard]] double width() const { return spread + unmet_now; }
        void look(double level) { unmet_now = scale * unmet.at(none_of(randomisations * size, level)); }
    };
    std::vector<Term> terms;
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const SampledSum sum = point_sum(k, hidden_[k]);
        const EstimatedSum now = estimate_of(sum, level);
        const SampledSum::Term& term = sum.terms.front();
        terms.push_back(
            {margin * (now.half_width() - now.unmet), std::abs(term.scale), term.share.unmet, sizes_[k], now.unmet});
    }
    const auto is_met = [&] {
        double squares = 0;
        double unmet = 0;
        for (const Term& term : terms) {
            squares += term.spread * term.spread;
            unmet = std::max(unmet, term.unmet_now);
        }
        return std::sqrt(squares) + unmet <= wanted.front();
    };
    while (!is_met()) {
        Term& widest = *std::max_element(terms.begin(), terms.end(),
                                         [](const Term& a, const Term& b) { return a.width() < b.width(); });
        if (static_cast<double>(widest.size) >= most_points_of_sequence) break;
        widest.size *= 2;
        widest.spread *= std::exp2(-rate_of_points);
        widest.look(level);
    }
    std::vector<std::uint64_t> sizes;
    for (const Term& term : terms) sizes.push_back(term.size);
    return sizes;
}

std::uint64_t Job::lost() const {
    std::uint64_t sum = 0;
    for (const RaySampling::Hits& hits : ray_hits_) sum += hits.lost;
    return sum;
}

}  // namespace ff::studies::form_factors

#include "studies/form_factors/sampling.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/visible_polygon.hpp"
#include "samplers/sampler.hpp"
#include "studies/form_factors/sampled_share.hpp"

#include <algorithm>
#include <memory>

namespace ff::studies {
void expect_more_time(const std::atomic<bool>* stop) {
    if (stop != nullptr && *stop) throw Stopped();
}

PointSampling::PointSampling(const Scene& scene, const SampledPair& pair, double wanted, PointEffort effort)
    : scene_(&scene), pair_(&pair), source_(pair.from), target_(pair.to) {
    FF_EXPECT(pair.exchange.method == ExchangeMethod::points);
    const auto is_polygon = [&](std::uint32_t surface) { return !corners(scene.surfaces[surface].shape).empty(); };
    const auto area_of = [&](std::uint32_t surface) { return area(scene.surfaces[surface].shape); };
    const bool either_way = is_polygon(source_) && is_polygon(target_);
    if (either_way ? area_of(target_) < area_of(source_) : !is_polygon(target_)) std::swap(source_, target_);
    cells_ = divide(scene.surfaces[source_], scene.surfaces[target_], pair.exchange.blockers,
                    effort == PointEffort::sized ? pair.exchange.area : std::nullopt, wanted);
}

PointSampling::Side PointSampling::side(bool hidden) const {
    if (!has_sides()) return {{}, 1, unmet(cells_, false)};
    const BoundedValue<double> whole = *pair_->exchange.area;
    const BoundedValue<double>& umbra = cells_.umbra;
    const BoundedValue<double>& open = cells_.open;
    if (hidden) return {{whole.value - umbra.value, umbra.error}, -1, unmet(cells_, true)};
    // Where nothing is divided, the whole is sampled, and nothing is known.
    if (cells_.is_whole()) return {{}, 1, unmet(cells_, false)};
    return {{whole.value - umbra.value - open.value, umbra.error + open.error}, 1, unmet(cells_, false)};
}

double PointSampling::cost() const {
    // Measured: benchmarks/README.md.
    double sum = 1;
    for (const SourceCell& cell : cells_.mixed) sum += cell.share * (9 + 3 * static_cast<double>(cell.blockers.size()));
    return sum;
}

PointSums PointSampling::run(StreamKey key, std::uint32_t randomisation, std::uint64_t points,
                             const std::atomic<bool>* stop) const {
    PointSums sums;
    const std::vector<SourceCell>& cells = cells_.mixed;
    if (cells.empty()) return sums;
    const SurfaceMap map(scene_->surfaces[source_]);
    const VisiblePolygon target(scene_->surfaces[target_], pair_->exchange.blockers);
    const auto add = [&](const SourceCell& cell, double s, double t) {
        const SurfacePoint place = map.at(s, t);
        const VisiblePolygon::Factors factors = target.from(place.position, place.normal, cell.blockers);
        const double weight = cell.area / cell.share;
        sums.visible += weight * std::max(0.0, factors.visible);
        sums.hidden += weight * std::max(0.0, factors.whole - factors.visible);
    };
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = 2;
    const samplers::CatalogueEntry& sobol = samplers::house_sampler();
    // Points on the whole source, and more in rough cells: a place counts by the sum of both densities.
    const auto visit = [&](std::uint32_t trial, std::uint64_t size, const auto& at) {
        const auto sampler = sobol.make({.points = size, .dimension = 2});
        const Stream stream{.key = key, .trial = trial, .source = source_, .target = target_ + 1};
        for (std::uint64_t first = 0; first < size; first += block->size) {
            expect_more_time(stop);
            block->size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, size - first));
            sampler->fill(stream, first, *block);
            for (std::size_t i = 0; i < block->size; ++i) at(block->coordinate[0][i], block->coordinate[1][i]);
        }
    };
    visit(randomisation, points, [&](double s, double t) {
        if (const SourceCell* cell = cells_.at(s, t)) add(*cell, s, t);
    });
    if (cells_.extra > 0) {
        const auto extra = static_cast<std::uint64_t>(cells_.extra * static_cast<double>(points));
        visit(randomisation + randomisations, extra, [&](double x, double y) {
            const auto after = std::upper_bound(cells.begin(), cells.end(), x, [](double u, const SourceCell& cell) {
                return u < cell.first + cell.extra;
            });
            if (after == cells.end()) return;
            const double s = after->s0 + (after->s1 - after->s0) * ((x - after->first) / after->extra);
            add(*after, s, after->t0 + (after->t1 - after->t0) * y);
        });
    }
    sums.visible /= static_cast<double>(points);
    sums.hidden /= static_cast<double>(points);
    return sums;
}

}  // namespace ff::studies

#include "studies/form_factors/sampling.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/visible_polygon.hpp"
#include "samplers/sampler.hpp"
#include "studies/form_factors/division/sampled_share.hpp"
#include "studies/form_factors/division/source_division.hpp"

#include <algorithm>
#include <memory>

namespace ff::studies::form_factors {
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
    for (const SourceCell& cell : cells_.mixed) sum += cell.share * (8 + static_cast<double>(cell.blockers.size()));
    return sum;
}

void PointSampling::run(StreamKey key, std::uint32_t first, std::uint64_t points, const std::atomic<bool>* stop,
                        std::span<PointSums> sums) const {
    std::fill(sums.begin(), sums.end(), PointSums{});
    const std::vector<SourceCell>& cells = cells_.mixed;
    if (cells.empty()) return;
    const SurfaceMap map(scene_->surfaces[source_]);
    const VisiblePolygon target(scene_->surfaces[target_], pair_->exchange.blockers,
                                source_ == pair_->from ? FacedEnd::from : FacedEnd::to);
    const auto add = [&](PointSums& sum, const SourceCell& cell, double s, double t) {
        const SurfacePoint place = map.at(s, t);
        const VisiblePolygon::Factors factors = target.from(place.position, place.normal, cell.blockers);
        const double weight = cell.area / cell.share / static_cast<double>(points);
        sum.visible += weight * std::max(0.0, factors.visible);
        sum.hidden += weight * std::max(0.0, factors.whole - factors.visible);
    };
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = 2;
    const samplers::CatalogueEntry& sobol = samplers::house_sampler();
    // Points on the whole source, and more in rough cells: a place counts by the sum of both densities.
    const auto visit = [&](std::uint32_t first_trial, std::uint64_t size, const auto& at) {
        const auto sampler = sobol.make({.points = size, .dimension = 2});
        for (std::uint32_t k = 0; k < sums.size(); ++k) {
            const Stream stream{.key = key, .trial = first_trial + k, .source = source_, .target = target_ + 1};
            for (std::uint64_t begin = 0; begin < size; begin += block->size) {
                expect_more_time(stop);
                block->size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, size - begin));
                sampler->fill(stream, begin, *block);
                for (std::size_t i = 0; i < block->size; ++i)
                    at(sums[k], block->coordinate[0][i], block->coordinate[1][i]);
            }
        }
    };
    visit(first, points, [&](PointSums& sum, double s, double t) {
        if (const SourceCell* cell = cells_.at(s, t)) add(sum, *cell, s, t);
    });
    const auto extra = static_cast<std::uint64_t>(cells_.extra * static_cast<double>(points));
    if (extra == 0) return;
    visit(first + randomisations, extra, [&](PointSums& sum, double x, double y) {
        const auto after = std::upper_bound(cells.begin(), cells.end(), x, [](double u, const SourceCell& cell) {
            return u < cell.first + cell.extra;
        });
        if (after == cells.end()) return;
        const auto [s0, s1, t0, t1] = after->range;
        add(sum, *after, s0 + (s1 - s0) * ((x - after->first) / after->extra), t0 + (t1 - t0) * y);
    });
}

}  // namespace ff::studies::form_factors

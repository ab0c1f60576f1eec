#include "studies/form_factors/sampling.hpp"

#include "core/contract.hpp"
#include "core/surface_map.hpp"
#include "core/visible_polygon.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <memory>

namespace ff::studies {
namespace {

constexpr double relative_rounding = 1e-13;

}  // namespace

void expect_more_time(const std::atomic<bool>* stop) {
    if (stop != nullptr && *stop) throw Stopped();
}

PointSampling::PointSampling(const Scene& scene, const SampledPair& pair)
    : scene_(&scene), pair_(&pair), source_(pair.from), target_(pair.to) {
    FF_EXPECT(pair.exchange.method == ExchangeMethod::points);
    const auto is_polygon = [&](std::uint32_t surface) { return !corners(scene.surfaces[surface].shape).empty(); };
    const auto area_of = [&](std::uint32_t surface) { return area(scene.surfaces[surface].shape); };
    const bool either_way = is_polygon(source_) && is_polygon(target_);
    if (either_way ? area_of(target_) < area_of(source_) : !is_polygon(target_)) std::swap(source_, target_);
    source_area_ = area_of(source_);
}

PointSums PointSampling::run(StreamKey key, std::uint32_t randomisation, std::uint64_t points,
                             const std::atomic<bool>* stop) const {
    const auto sampler = samplers::find("sobol").make({.points = points, .dimension = 2});
    const Stream stream{.key = key, .trial = randomisation, .source = source_, .target = target_ + 1};
    const SurfaceMap map(scene_->surfaces[source_]);
    const VisiblePolygon target(scene_->surfaces[target_], pair_->exchange.blockers);
    const auto block = std::make_unique<WeightedBlock>();
    block->dimension = 2;
    PointSums sums;
    for (std::uint64_t first = 0; first < points; first += block->size) {
        expect_more_time(stop);
        block->size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, points - first));
        sampler->fill(stream, first, *block);
        for (std::size_t i = 0; i < block->size; ++i) {
            const SurfacePoint place = map.at(block->coordinate[0][i], block->coordinate[1][i]);
            const VisiblePolygon::Factors factors = target.from(place.position, place.normal);
            const double hidden = std::max(0.0, factors.whole - factors.visible);
            sums.visible += std::max(0.0, factors.visible);
            sums.hidden += hidden;
            sums.saw += factors.visible > relative_rounding * factors.whole;
            sums.missed += hidden > relative_rounding * factors.whole;
        }
    }
    sums.visible /= static_cast<double>(points);
    sums.hidden /= static_cast<double>(points);
    return sums;
}

}  // namespace ff::studies

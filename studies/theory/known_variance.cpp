#include "studies/theory/known_variance.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/patches/face_averages.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

/// Whether some term of a quantity has no variance. Faces count from 1; 0 stands for all.
bool has_infinite_term(const Method& method, const Scene& scene, int from, int to) {
    const EstimatorEntry& estimator = find_estimator(method.estimator);
    const EstimatorOptions options = estimator_options(method);
    const int faces = static_cast<int>(scene.faces.size());
    for (int i = from == 0 ? 1 : from; i <= (from == 0 ? faces : from); ++i) {
        for (int j = to == 0 ? 1 : to; j <= (to == 0 ? faces : to); ++j) {
            if (i != j && !estimator.finite_variance(options, scene, i - 1, j - 1)) return true;
        }
    }
    return false;
}

/// Hits of all trials together from which Student's t holds for their mean: below, its tails are too heavy.
constexpr double least_hits = 30;

/// Independent evaluations among those of a trial; 1 where they are not independent of each other.
double independent_parts(const Method& method, std::uint64_t evaluations) {
    using samplers::Spread;
    const auto all = static_cast<double>(evaluations);
    if (method.sampler.empty()) return 1;
    switch (samplers::find(method.sampler).info.spread) {
        case Spread::independent:
        case Spread::grid:  // one in each cell
            return all;
        case Spread::mirrored:
            return all / 2;
        default:
            return 1;
    }
}

/// The only surface of a face; null where there are several.
const Surface* only_surface(const Scene& scene, int face) {
    const Surface* only = nullptr;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face != face) continue;
        if (only != nullptr) return nullptr;
        only = &surface;
    }
    return only;
}

}  // namespace

VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity) {
    if (!is_randomised(method)) return VarianceStatus::none;
    return has_infinite_term(method, scene, quantity.from, quantity.to) ? VarianceStatus::infinite
                                                                        : VarianceStatus::finite;
}

bool too_few_hits(std::optional<double> lattice, std::optional<double> reference, std::size_t trials) {
    if (!lattice || !reference || *reference == 1.0) return false;
    const double rays = static_cast<double>(trials) / *lattice;
    return std::min(*reference, std::abs(1.0 - *reference)) * rays < least_hits;
}

stats::KnownLimits known_limits(const Method& method, const Scene& scene, Subdivision subdivision, Quantity quantity,
                                std::uint64_t evaluations, std::size_t trials) {
    if (evaluations == 0) return {};
    if (quantity.kind == QuantityKind::row_sum) {
        stats::KnownLimits sum;
        for (int to = 1; to <= static_cast<int>(scene.faces.size()); ++to) {
            const Quantity term{QuantityKind::form_factor, quantity.from, to};
            const auto limits = known_limits(method, scene, subdivision, term, evaluations, trials);
            if (limits.unmet.largest > 0)
                sum.unmet = {.largest = sum.unmet.largest + limits.unmet.largest,
                             .evaluations = limits.unmet.evaluations};
        }
        return sum;
    }
    if (quantity.kind != QuantityKind::form_factor) return {};
    const int from = quantity.from - 1;
    const int to = quantity.to - 1;
    if (method.completion == Completion::reciprocal && from > to) {
        // The factor is another one, times the ratio of the areas.
        const double ratio = face_area(scene, to) / face_area(scene, from);
        auto limits =
            known_limits(method, scene, subdivision, {quantity.kind, quantity.to, quantity.from}, evaluations, trials);
        limits.largest_part *= ratio;
        limits.unmet.largest *= ratio;
        return limits;
    }
    const EstimatorEntry& estimator = find_estimator(method.estimator);
    const EstimatorInfo& info = estimator.info;
    stats::KnownLimits limits;
    // Where points serve pairs of patches, a factor is a sum over the patches of the target.
    const bool is_sum = info.points == PointsServe::pairs && subdivision.m != 1;
    if (only_surface(scene, from) && only_surface(scene, to) && !is_sum)
        limits.largest_part = info.largest_value / independent_parts(method, evaluations);
    // Too few hits test nothing in any case, where hits are counted.
    if (info.observes == Observes::hits && has_one_surface_a_face(scene)) return limits;
    const double terms = is_sum && std::isfinite(info.largest_value) ? static_cast<double>(subdivision.per_part()) : 1;
    // A point and its mirror image may miss the same places.
    const bool mirrored =
        !method.sampler.empty() && samplers::find(method.sampler).info.spread == samplers::Spread::mirrored;
    const double all = static_cast<double>(evaluations) * static_cast<double>(trials) / (mirrored ? 2 : 1);
    limits.unmet = {.largest = terms * estimator.largest_unmet(scene, from, to, all), .evaluations = all};
    return limits;
}

double rounding_of_bias(const Scene& scene, Quantity quantity) {
    constexpr double of_factors = 1e-15;
    constexpr double of_exchange_areas = 1e-18;
    if (quantity.kind != QuantityKind::form_factor) return static_cast<double>(scene.faces.size()) * of_factors;
    Eigen::AlignedBox3d box;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == quantity.from - 1 || surface.face == quantity.to - 1) box.extend(box_around(surface));
    }
    const double area = face_area(scene, quantity.from - 1);
    return of_factors + of_exchange_areas * box.diagonal().squaredNorm() / area;
}

bool has_independent_hits(const Method& method, Quantity quantity) {
    return quantity.kind == QuantityKind::form_factor && !method.sampler.empty() &&
           estimator_info(method).observes == Observes::hits && samplers::find(method.sampler).info.independent();
}

bool starts_anywhere(const Scene& scene, Subdivision subdivision, Quantity quantity) {
    const Surface* from = only_surface(scene, quantity.from - 1);
    return from != nullptr && subdivision.of(*from) == undivided;
}

}  // namespace ff::studies

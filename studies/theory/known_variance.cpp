#include "studies/theory/known_variance.hpp"

#include "core/visibility/contact.hpp"
#include "core/visibility/occlusion.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

bool is_of_parallelograms(const Scene& scene, int face) {
    return std::all_of(scene.surfaces.begin(), scene.surfaces.end(), [face](const Surface& surface) {
        return surface.face != face || std::holds_alternative<Parallelogram>(surface.shape);
    });
}

/// Points are graded between parallelograms, and not where they are looked at one by one.
bool are_graded(const Scene& scene, int from, int to) {
    return is_of_parallelograms(scene, from) && is_of_parallelograms(scene, to) && !may_be_occluded(scene, from, to);
}

bool is_infinite(const Method& method, const Scene& scene, int from, int to) {
    const Contact contact = closest_contact(scene, from - 1, to - 1);
    if (contact == Contact::none) return false;
    const PointMap map = are_graded(scene, from - 1, to - 1) ? method.map : PointMap::uniform;
    const auto index = kernel_tail_index(contact, map);
    return index && *index <= 2;
}

/// Whether some term of a quantity has no variance. Faces count from 1; 0 stands for all.
bool has_infinite_term(const Method& method, const Scene& scene, int from, int to) {
    const int faces = static_cast<int>(scene.faces.size());
    for (int i = from == 0 ? 1 : from; i <= (from == 0 ? faces : from); ++i) {
        for (int j = to == 0 ? 1 : to; j <= (to == 0 ? faces : to); ++j) {
            if (i != j && is_infinite(method, scene, i, j)) return true;
        }
    }
    return false;
}

/// Hits of all trials together from which Student's t holds for their mean: below, its tails are too heavy.
constexpr double least_hits = 30;

}  // namespace

VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity) {
    const bool deterministic = method.sampler.empty() || !samplers::find(method.sampler).info.randomised;
    if (deterministic) return VarianceStatus::none;
    if (method.estimator != Estimator::area_kernel) return VarianceStatus::finite;
    return has_infinite_term(method, scene, quantity.from, quantity.to) ? VarianceStatus::infinite
                                                                        : VarianceStatus::finite;
}

bool too_few_hits(std::optional<double> lattice, std::optional<double> reference, std::size_t trials) {
    if (!lattice || !reference || *reference == 1.0) return false;
    const double rays = static_cast<double>(trials) / *lattice;
    return std::min(*reference, std::abs(1.0 - *reference)) * rays < least_hits;
}

}  // namespace ff::studies

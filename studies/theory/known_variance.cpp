#include "studies/theory/known_variance.hpp"

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

}  // namespace ff::studies

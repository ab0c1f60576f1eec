#include "core/exact/known_factors.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/exact/exact_rooms.hpp"
#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <algorithm>

namespace ff {
namespace {

/// In scenes with more surfaces, pairs of faces are not examined one by one: that takes time proportional to the cube
/// of the number of surfaces.
constexpr std::size_t most_surfaces_pair_by_pair = 128;

}  // namespace

KnownFactors::KnownFactors(const Eigen::MatrixXd& factors) : KnownFactors(static_cast<std::size_t>(factors.rows())) {
    FF_EXPECT(factors.rows() == factors.cols());
    for (int from = 0; from < factors.rows(); ++from) {
        for (int to = 0; to < factors.cols(); ++to) set(from, to, factors(from, to));
    }
}

std::size_t KnownFactors::index(int from, int to) const {
    FF_EXPECT(from >= 0 && static_cast<std::size_t>(from) < faces_);
    FF_EXPECT(to >= 0 && static_cast<std::size_t>(to) < faces_);
    return static_cast<std::size_t>(from) * faces_ + static_cast<std::size_t>(to);
}

std::optional<double> KnownFactors::row_sum(int from) const {
    double sum = 0;
    for (std::size_t to = 0; to < faces_; ++to) {
        const auto factor = at(from, static_cast<int>(to));
        if (!factor) return std::nullopt;
        sum += *factor;
    }
    return sum;
}

KnownFactors known_factors(const Scene& scene) {
    KnownFactors known(scene.faces.size());
    const auto all = exact_room_factors(scene);
    if (all) known = KnownFactors(*all);
    const bool pair_by_pair = !all && mirrors(scene).empty() && scene.surfaces.size() <= most_surfaces_pair_by_pair;
    const auto faces = static_cast<int>(scene.faces.size());
    for (int from = 0; from < faces; ++from) {
        for (int to = 0; to < faces; ++to) {
            auto factor = known_form_factor(scene, from, to);
            if (!factor && pair_by_pair && !may_be_occluded(scene, from, to))
                factor = exact_form_factor(scene, from, to);
            if (factor) known.set(from, to, *factor);
        }
    }
    return known;
}

std::optional<double> hidden_share(const Scene& scene, const KnownFactors& known, int from, int to) {
    const auto factor = known.at(from, to);
    const auto open = exact_form_factor(scene, from, to);
    if (!factor || !open || *open == 0) return std::nullopt;
    return std::clamp(1 - *factor / *open, 0.0, 1.0);
}

}  // namespace ff

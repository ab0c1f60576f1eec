#include "core/estimators/pairs/contour.hpp"

#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/support/logarithm.hpp"
#include "core/visibility/facing.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <array>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

struct RimEdge {
    Vector3d begin;
    Vector3d along;
};

/// The rim of a patch, counter-clockwise as seen from the side that it radiates to.
std::array<RimEdge, 4> rim(const PatchView& patch) {
    const std::array<Vector3d, 4> corners = counter_clockwise(patch);
    std::array<RimEdge, 4> edges;
    for (std::size_t k = 0; k < 4; ++k) edges[k] = {corners[k], corners[(k + 1) % 4] - corners[k]};
    return edges;
}

/// Two edges whose distances count.
struct EdgePair {
    RimEdge from;
    RimEdge to;
    double product = 0;
};

/// What is known about two rims before any point is drawn: pairs of edges to sample, and the sum over those that
/// coincide.
struct RimPair {
    std::vector<EdgePair> sampled;
    double exact = 0;
    /// Square of the unit of length: a constant drops out of the sum over closed rims, but not out of its variance.
    double squared_unit = 1;
};

RimPair pair_up(const PatchPair& pair) {
    const auto from = rim(pair.from);
    const auto to = rim(pair.to);
    RimPair rims;
    rims.squared_unit = (pair.from.at(0.5, 0.5).position - pair.to.at(0.5, 0.5).position).squaredNorm();
    for (const RimEdge& a : from) {
        for (const RimEdge& b : to) {
            const double product = a.along.dot(b.along);
            if (product == 0) continue;
            const double size = a.along.norm();
            const double apart = (a.begin - b.begin - b.along).norm() + (a.begin + a.along - b.begin).norm();
            if (apart > 1e-12 * size) {
                rims.sampled.push_back({a, b, product});
            } else {  // the mean of ln(size * |s - t|)
                rims.exact += product * (0.5 * logarithm(size * size / rims.squared_unit) - 1.5);
            }
        }
    }
    return rims;
}

double sum_over(const RimPair& rims, double s, double t) {
    double sum = rims.exact;
    for (const EdgePair& pair : rims.sampled) {
        const double squared =
            (pair.to.begin + t * pair.to.along - pair.from.begin - s * pair.from.along).squaredNorm();
        if (squared > 0) sum += 0.5 * pair.product * logarithm(squared / rims.squared_unit);
    }
    return sum;
}

}  // namespace

std::string Contour::refusal(const EstimatorOptions& options, const Scene& scene) {
    return refusal_for(info.name, options, scene);
}

std::string Contour::refusal_for(std::string_view estimator, const EstimatorOptions& /*options*/, const Scene& scene) {
    if (is_convex(scene)) return {};
    return fmt::format(
        "{} cannot be used in scene '{}' (some of its surfaces lie behind the plane of another). Use estimator = "
        "\"solid_angle\".",
        estimator, scene.name);
}

void Contour::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates =
        average_over_pairs(*scene_, task, info.dimension, [](const PatchPair& pair, const WeightedBlock& block) {
            const RimPair rims = pair_up(pair);
            double sum = 0;
            for (std::size_t i = 0; i < block.size; ++i)
                sum += block.weight[i] * sum_over(rims, block.coordinate[0][i], block.coordinate[1][i]);
            return sum / (2 * std::numbers::pi * pair.from.area);
        });
}

}  // namespace ff

#include "core/estimators/pairs/control_variate.hpp"

#include "core/estimators/graded_map.hpp"
#include "core/estimators/pairs/patch_pairs.hpp"
#include "core/estimators/unmet.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"
#include "core/visibility/touching.hpp"

#include <Eigen/Core>

#include <numbers>

namespace ff {
namespace {

Eigen::MatrixXd unoccluded_factors(const Scene& scene) {
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(faces, faces);
    for (const Surface& from : scene.surfaces) {
        if (!is_of_face(from)) continue;
        for (const Surface& to : scene.surfaces) {
            if (!is_of_face(to) || !face_each_other(from, to)) continue;
            factors(from.face, to.face) +=
                polygon_exchange_area(corners_of<double>(from), corners_of<double>(to)).value /
                face_area(scene, from.face);
        }
    }
    return factors;
}

/// The kernel that two points lose because something hides one from the other; 0 where nothing does.
double hidden(const PatchPair& pair, const SurfacePoint& from, const SurfacePoint& to) {
    const Eigen::Vector3d apart = to.position - from.position;
    const double leaving = apart.dot(from.normal);
    const double arriving = -apart.dot(to.normal);
    if (!(leaving > 0 && arriving > 0)) return 0;
    if (sees(from.position, *pair.from.surface, to.position, *pair.to.surface, *pair.blockers)) return 0;
    const double squared = apart.squaredNorm();
    return pair.to.area * leaving * arriving / (std::numbers::pi * squared * squared);
}

}  // namespace

ControlVariate::ControlVariate(const Scene& scene, TracerChoice tracer)
    : SceneEstimator(scene, tracer), unoccluded_(unoccluded_factors(scene)) {}

std::optional<Integrand> ControlVariate::integrand(const EstimatorOptions& /*options*/, PairClass pair_class,
                                                   Hiding hiding) {
    if (hiding == Hiding::none) return std::nullopt;
    return pair_class == PairClass::adjacent ? Integrand::unbounded : Integrand::jumping;
}

bool ControlVariate::finite_variance(const EstimatorOptions& /*options*/, const Scene& scene, int from, int to) {
    return closest_contact(scene, from, to) == Contact::none || !may_be_occluded(scene, from, to);
}

double ControlVariate::largest_unmet(const Scene& scene, int from, int to, double /*evaluations*/) {
    return may_be_occluded(scene, from, to) ? largest_kernel(scene, from, to) : 0;
}

void ControlVariate::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    outcome.estimates =
        unoccluded_ -
        average_over_pairs(
            scene(), task, info.dimension,
            [](const PatchPair& pair, const WeightedBlock& block) {
                double sum = 0;
                for (std::size_t i = 0; i < block.size; ++i) {
                    sum += block.weight[i] * hidden(pair, pair.from.at(block.coordinate[0][i], block.coordinate[1][i]),
                                                    pair.to.at(block.coordinate[2][i], block.coordinate[3][i]));
                }
                return sum;
            },
            PairsOf::occluded);
}

}  // namespace ff

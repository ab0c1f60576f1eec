#pragma once

#include "core/estimators/entry.hpp"

#include <string>

namespace ff {

/// Exact unoccluded factors, minus a sampled estimate of the occluded part.
class ControlVariate : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "control_variate",
        .summary = "the exact factor without occlusion, less the kernel at occluded pairs of points",
        .details =
            "The factor without occlusion is known exactly, by the contour integral; it is the control\n"
            "variate of the area kernel. A 4-D point gives a point on each patch of an ordered pair, and only where "
            "they do\nnot see each other is the kernel subtracted. Unoccluded pairs are exact and take no "
            "points.\nUnbiased with random points; estimates may be negative where nearly all is occluded. Where "
            "faces touch that\nmay be occluded, the variance is infinite. Faces have to be parallelograms "
            "and triangles;\nsamples_per_patch counts points per pair of patches.",
        .reference = "owen2013",
        .dimension = 4,
        .points = PointsServe::pairs,
        .sees_occluders = true,
        .needs_polygons = true,
        .nanoseconds = 60,
    };

    /// The integrand jumps at the edge of a shadow; without a shadow there is no error.
    static std::optional<Integrand> integrand(const EstimatorOptions& options, PairClass pair_class, Hiding hiding);
    static bool finite_variance(const EstimatorOptions& options, const Scene& scene, int from, int to);
    static double largest_unmet(const Scene& scene, int from, int to, double evaluations);

    ControlVariate(const Scene& scene, TracerChoice tracer);
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    Eigen::MatrixXd unoccluded_;  ///< between faces
};

}  // namespace ff

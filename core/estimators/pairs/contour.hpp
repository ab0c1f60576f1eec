#pragma once

#include "core/estimators/estimator.hpp"

#include <string>
#include <string_view>

namespace ff {

/// The double contour integral over the rims of two patches, by any point set.
class Contour {
  public:
    static constexpr EstimatorInfo info{
        .name = "contour",
        .summary = "the double contour integral: ln r at pairs of points on the rims of two patches",
        .details =
            "A 2-D point gives a point on an edge of the source patch (1) and one on an edge of the target patch (1), "
            "the\nsame for all pairs of edges; the value is the sum over these of ln r times the scalar product of the "
            "edges.\nEdges that coincide are done exactly. With gauss_legendre it is the classical contour integration "
            "with so many\nnodes an edge; unbiased with random points, of finite variance also where faces touch. It "
            "knows nothing of what\nhides or lies behind: faces have to be parallelograms and triangles, each wholly "
            "in front of all others.\nsamples_per_patch counts points per pair of patches.",
        .reference = "sparrow1963",
        .dimension = 2,
        .points = PointsServe::pairs,
        .needs_polygons = true,
        .nanoseconds = 200,
        .integrands = {.apart = Integrand::smooth, .adjacent = Integrand::rough},
    };

    static std::string refusal(const EstimatorOptions& options, const Scene& scene);
    /// As above, on behalf of another estimator that integrates along rims.
    static std::string refusal_for(std::string_view estimator, const EstimatorOptions& options, const Scene& scene);

    Contour(const Scene& scene, TracerChoice /*tracer*/) : scene_(&scene) {}
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    const Scene* scene_;
};

}  // namespace ff

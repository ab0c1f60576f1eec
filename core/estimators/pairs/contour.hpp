#pragma once

#include "core/estimators/entry.hpp"

#include <cstdint>
#include <string>

namespace ff {

/// The double contour integral over the rims of two patches, by any point set.
class Contour : public SceneEstimator {
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

    using SceneEstimator::SceneEstimator;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;
};

/// Gauss-Kronrod rules along the rim of the source, bisected where the two rules differ most.
class AdaptiveContour : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "adaptive_contour",
        .summary = "the contour integral by adaptive Gauss-Kronrod quadrature, with the error that it claims",
        .details =
            "Of the double contour integral the inner one, over the rim of the target, is elementary; the outer one "
            "is done\nby Kronrod's rule with 15 nodes on panels, at first one for each edge of the source patch. The "
            "difference from Gauss's\nrule with 7 of the nodes is the error that it claims; the panel with the largest "
            "is halved, as long as evaluations are\nleft (QUADPACK's way). A study shows how often the claim holds. "
            "Deterministic; samples_per_patch counts evaluations\nfor a pair of patches: 60 for the four edges, and 30 "
            "for every halving. It knows nothing of what hides or lies\nbehind: faces have to be parallelograms and "
            "triangles, each wholly in front of all others.",
        .reference = "piessens1983",
        .points = PointsServe::pairs,
        .own_points = true,
        .needs_polygons = true,
        .nanoseconds = 200,
    };

    static std::string refusal(const EstimatorOptions& options, const Scene& scene);
    static std::string size_problem(std::uint64_t samples);

    using SceneEstimator::SceneEstimator;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;
};

}  // namespace ff

#pragma once

#include "core/estimators/estimator.hpp"

#include <cstdint>
#include <string>

namespace ff {

/// Gauss-Kronrod rules along the rim of the source, bisected where the two rules differ most.
class AdaptiveContour {
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

    AdaptiveContour(const Scene& scene, TracerChoice /*tracer*/) : scene_(&scene) {}
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    const Scene* scene_;
};

}  // namespace ff

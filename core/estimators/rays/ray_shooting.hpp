#pragma once

#include "core/estimators/entry.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace ff {

/// One trial of ray shooting (the paper's SR): `samples_per_patch` cosine-distributed rays from every patch. `tally` is
/// replaced by this trial's outcome, `sums` (empty, or from earlier trials of the same size) added to; null where there
/// are too many patches to keep them separate.
/// @pre points.equal_weights()   `key` and `trial` select the streams
void ray_shooting(const Scene& scene, Subdivision subdivision, const Tracer& tracer, const PointSource& points,
                  std::uint64_t samples_per_patch, Allocation allocation, StreamKey key, std::uint32_t trial,
                  RayTally& tally, PatchSums* sums);

/// The paper's SR, as an estimator.
class RayShooting : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "ray_shooting",
        .summary = "rays from every patch, cosine distributed; counts what they hit (the paper's SR)",
        .details =
            "A 4-D point gives the origin on the source patch (2) and the direction (2). The estimate of F(i, j) is "
            "the share\nof the rays from face i that hit face j: integer counts, unbiased, and nothing is chosen about "
            "the target.\nWorks with every sampler of equal weights. allocation = \"face\" runs one sequence over all "
            "patches of a face.\nRays that leave a closed scene are lost rays; they are counted and reported.",
        .reference = "shirley1991",
        .dimension = 4,
        .points = PointsServe::patches,
        .observes = Observes::hits,
        .patch_factors = PatchFactors::rays,
        .has_tracer = true,
        .sees_occluders = true,
        .sees_reflections = true,
        .largest_value = 1,
        .evaluations = "rays",
        .integrands = {.apart = Integrand::jumping, .adjacent = Integrand::jumping},
    };

    /// The box tracer is for empty boxes; rays have single precision.
    static std::string refusal(const EstimatorOptions& options, const Scene& scene);
    static double nanoseconds(const EstimatorOptions& options, const Scene& scene);
    static double largest_unmet(const Scene& /*scene*/, int /*from*/, int /*to*/, double /*evaluations*/) {
        return info.largest_value;
    }

    RayShooting(const Scene& scene, TracerChoice tracer)
        : SceneEstimator(scene, tracer), tracer_(make_tracer(scene, tracer)) {}
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;

  private:
    std::unique_ptr<const Tracer> tracer_;
};

}  // namespace ff

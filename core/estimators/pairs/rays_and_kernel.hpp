#pragma once

#include "core/estimators/entry.hpp"

namespace ff {

/// The weight of a place that one of two ways found with density p, and the other finds with density q.
enum class Heuristic {
    balance,  ///< p / (p + q)
    power,    ///< p^2 / (p^2 + q^2)
};

/// Declarations that both heuristics share, besides their own ones.
constexpr EstimatorInfo two_ways(EstimatorInfo info) {
    info.dimension = 4;
    info.points = PointsServe::pairs;
    info.sees_occluders = true;
    info.nanoseconds = 100;
    // The value of a ray jumps where the target ends; where faces touch, no theory holds.
    info.integrands = {.apart = Integrand::jumping, .adjacent = Integrand::rough};
    return info;
}

/// The common part of the estimators with either heuristic.
class TwoWays : public SceneEstimator {
  public:
    /// A ray counts almost 1 where it meets a target that is small from there.
    static double largest_unmet(const Scene& scene, int from, int to, double evaluations);

    using SceneEstimator::SceneEstimator;

  protected:
    /// Gives the same bits on every CPU, except for rays to round surfaces: the C library rounds their azimuths.
    [[nodiscard]] Eigen::MatrixXd estimate(const EstimatorTask& task, Heuristic heuristic) const;
};

/// Rays and the area kernel in one, weighted by the balance heuristic.
class RaysAndKernel : public TwoWays {
  public:
    static constexpr EstimatorInfo info = two_ways({
        .name = "rays_and_kernel",
        .summary = "multiple importance sampling: a ray and a kernel value for each point (balance heuristic)",
        .details =
            "A 4-D point gives a point on the source patch (2), and from there both a point on the target patch and a\n"
            "cosine-distributed ray (2). Each of the two finds a place on the target that it weighs by p / (p + 1/A), "
            "p the\ndensity of rays at the place and A the target's area: between 0 and 1, so that the variance is "
            "finite wherever\nfaces touch, with every shape. Unbiased with random points. Occlusion is tested "
            "point by\npoint, in double precision. samples_per_patch counts points per pair of patches.",
        .reference = "veach1995",
        .largest_value = 2,
    });

    using TwoWays::TwoWays;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
        outcome.estimates = estimate(task, Heuristic::balance);
    }
};

/// The same, weighted by the power heuristic.
class RaysAndKernelPower : public TwoWays {
  public:
    static constexpr EstimatorInfo info = two_ways({
        .name = "rays_and_kernel_power",
        .summary = "multiple importance sampling: a ray and a kernel value for each point (power heuristic)",
        .details = "As rays_and_kernel, with weights that leave less to the worse of the two ways: with q = 1/A, "
                   "a place that a ray\nfound counts p^2 / (p^2 + q^2), and one laid on the target p q / (p^2 + q^2). "
                   "Values lie between 0 and 3/2.\nUnbiased with random points.",
        .reference = "veach1995",
        .largest_value = 1.5,
    });

    using TwoWays::TwoWays;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
        outcome.estimates = estimate(task, Heuristic::power);
    }
};

}  // namespace ff

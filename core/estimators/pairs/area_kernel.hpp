#pragma once

#include "core/estimators/entry.hpp"
#include "core/estimators/graded_map.hpp"
#include "core/estimators/unmet.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace ff {

/// One trial of the area-to-area estimator: the integral over both patches of cos_i cos_j V / (pi r^2), divided by the
/// source area, with the 4-D points (2 on the source, 2 on the target patch) and weights of `points`; patch factors are
/// averaged over source patches and summed over target patches into faces. The patch-to-patch matrix is never formed.
///
/// Unbiased with random points, but with infinite variance where patches share an edge (tail index 3/2) or a vertex
/// (2), unless `map` is graded (core/estimators/graded_map). With tensor Gauss-Legendre points on a uniform map it is
/// the paper's PDM. V is 0 where something stands between two points and 1 elsewhere. For pairs of surfaces that
/// nothing can stand between (core/visibility/occlusion) it costs nothing; for others it is tested point by point, in
/// double precision. On patches that are not parallelograms, points are placed as SurfaceMap does, and a graded map has
/// no effect. Streams are keyed by ordered patch pair. Points that are not randomised serve all pairs; if they are also
/// exchangeable, the sum for (j, i) equals that for (i, j) and is computed once. Points that coincide (r = 0) count as
/// 0. The same bits on every CPU.
/// @param sums  empty, or from earlier trials of the same size: the trial's patch factors are added. Null: not wanted
/// @return face-to-face matrix, every entry estimated directly (no reciprocity); the diagonal is 0 where a face does
/// not see itself
Eigen::MatrixXd area_kernel(const Scene& scene, Subdivision subdivision, const PointSource& points, PointMap map,
                            StreamKey key, std::uint32_t trial, PatchFactorSums* sums = nullptr);

/// The paper's PDM and its Monte Carlo variants, as an estimator.
class AreaKernel : public SceneEstimator {
  public:
    static constexpr EstimatorInfo info{
        .name = "area_kernel",
        .summary = "cos·cos/(pi r^2) at pairs of points on two patches (with gauss_legendre: the paper's PDM)",
        .details =
            "A 4-D point gives a point on each patch of an ordered pair; samples_per_patch counts points per pair. "
            "Unbiased with\nrandom points, but where patches share an edge or a vertex the kernel is unbounded: the "
            "tail index is 3/2 or 2, the\nvariance infinite, and no interval is shown. With Gauss-Legendre nodes on "
            "both patches it is the parametric\ndifferential method (PDM); its error near common edges falls as 1/m "
            "only. map = \"graded\" lays points s^3 from a common\nedge (s^2 from a common vertex): tail index 5/2, "
            "finite variance. Occlusion is tested\npoint by point.",
        .reference = "baranoski1992",
        .dimension = 4,
        .points = PointsServe::pairs,
        .patch_factors = PatchFactors::kernels,
        .has_map = true,
        .sees_occluders = true,
        .evaluations = "kernel values",
        .nanoseconds = 1.5,
    };

    static std::optional<Integrand> integrand(const EstimatorOptions& options, PairClass pair_class, Hiding hiding);
    static bool finite_variance(const EstimatorOptions& options, const Scene& scene, int from, int to) {
        return kernel_has_variance(scene, from, to, options.map);
    }
    static constexpr auto largest_unmet = &largest_unmet_kernel;

    using SceneEstimator::SceneEstimator;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const;
};

}  // namespace ff

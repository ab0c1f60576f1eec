#pragma once

#include "core/estimators/graded_map.hpp"
#include "core/geometry/scene.hpp"
#include "core/points/points.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ff {

/// Sums over trials of patch-to-face factors and of their squares, [patch * faces + face].
struct PatchFactorSums {
    std::vector<double> factors;
    std::vector<double> factors_squared;
};

/// One trial of the area-to-area estimator: the integral over both patches of cos_i cos_j V / (pi r^2), divided by the
/// source area, with the 4-D points (2 on the source, 2 on the target patch) and weights of `points`; patch factors are
/// averaged over source patches and summed over target patches into faces. The patch-to-patch matrix is never formed.
///
/// Unbiased with random points, but of infinite variance where patches share an edge (tail index 3/2) or a vertex (2),
/// unless `map` is graded (core/estimators/graded_map). With tensor Gauss-Legendre points laid evenly it is the paper's
/// PDM. V is 0 where something stands between two points and 1 elsewhere. Pairs of surfaces that nothing can stand
/// between (core/visibility/occlusion) cost nothing for it; others are looked at point by point, in double precision.
/// Of patches that are no parallelograms, points are laid as SurfaceMap does, and a graded map changes nothing. Streams
/// are keyed by ordered patch pair. Points that are not randomised serve all pairs; where they are exchangeable as
/// well, the sum for (j, i) is the one for (i, j) and is done once. Points that coincide (r = 0) count as 0. The same
/// bits on every CPU.
/// @param sums  empty, or from earlier trials of the same size: the trial's patch factors are added. Null: not wanted
/// @return face-to-face matrix, every entry estimated directly (no reciprocity); the diagonal is 0 where a face does
/// not see itself
Eigen::MatrixXd area_kernel(const Scene& scene, Subdivision subdivision, const PointSource& points, PointMap map,
                            StreamKey key, std::uint32_t trial, PatchFactorSums* sums = nullptr);

}  // namespace ff

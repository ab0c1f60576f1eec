#pragma once

#include "core/geometry/scene.hpp"
#include "core/patches/allocation.hpp"
#include "core/points/points.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace ff {

/// One trial of the point-to-polygon estimator: at every 2-D point of `points` on a
/// source patch, the exact form factor from the differential area there to each visible surface
/// (core/formulas/polygon_factor), averaged over points and patches and added up into faces. One set of points serves
/// all targets. No error is left but that of the two integrals over the source.
///
/// Unbiased with random points; the integrand lies in [0, 1] and is smooth, but for corners that two faces share.
/// Streams are keyed as in `ray_shooting`: by source patch, or by part of a grid with Allocation::face.
/// Weights of `points` count with Allocation::patch; with Allocation::face all must be equal. The same bits on every
/// CPU.
/// @param samples_per_patch  points.points() with Allocation::patch, and so many a patch with Allocation::face
/// @return face-to-face matrix, every entry estimated directly; the diagonal is 0 where a face does not see itself
/// @pre all surfaces are parallelograms, and nothing stands between two of them: core/visibility/occlusion.hpp
Eigen::MatrixXd point_to_polygon(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                 std::uint64_t samples_per_patch, Allocation allocation, StreamKey key,
                                 std::uint32_t trial);

}  // namespace ff

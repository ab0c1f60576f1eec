#pragma once

#include "core/graded_map.hpp"
#include "core/points.hpp"
#include "core/radiosity/repair.hpp"
#include "core/ray_shooting.hpp"
#include "core/scene.hpp"
#include "core/tracer.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace ff {

/// Form factors from every patch (rows, in the order of Subdivision) to every patch, as one trial of ray shooting gives
/// them: the same rays as `ray_shooting` with these arguments, told apart by the patches that they hit. Rows sum to 1
/// but for lost rays. 8 bytes for each pair of patches.
Eigen::MatrixXd shoot_patch_factors(const Scene& scene, Subdivision subdivision, const Tracer& tracer,
                                    const PointSource& points, std::uint64_t samples_per_patch, Allocation allocation,
                                    StreamKey key, std::uint32_t trial);

/// The same of one trial of `area_kernel` with these arguments: the sums over pairs of patches that it adds up to
/// faces, equal to it but for rounding. Some 100 bytes for each pair of patches.
Eigen::MatrixXd kernel_patch_factors(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                     PointMap map, StreamKey key, std::uint32_t trial);

/// The exact ones. Empty where some pair of surfaces has no elementary formula.
std::optional<Eigen::MatrixXd> exact_patch_factors(const Scene& scene, Subdivision subdivision);

/// Area of every patch, in the order of Subdivision.
Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision);

/// Which patches lie in front of each other, whatever stands between them.
Sight patch_sight(const Scene& scene, Subdivision subdivision);

}  // namespace ff

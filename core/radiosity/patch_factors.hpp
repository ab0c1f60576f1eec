#pragma once

#include "core/estimators/graded_map.hpp"
#include "core/estimators/ray_shooting.hpp"
#include "core/geometry/scene.hpp"
#include "core/points/points.hpp"
#include "core/radiosity/repair.hpp"
#include "core/tracing/tracer.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace ff {

/// How many patches surfaces that belong to a face have. In matrices between patches these are the rows and columns,
/// in the order of PatchOrder.
std::uint32_t radiating_patches(const Scene& scene, Subdivision subdivision);

/// Form factors from every patch to every patch, as one trial of ray shooting gives
/// them: the same rays as `ray_shooting` with these arguments, told apart by the patches that they hit. Rows sum to 1
/// but for lost rays. 8 bytes for each pair of patches.
Eigen::MatrixXd shoot_patch_factors(const Scene& scene, Subdivision subdivision, const Tracer& tracer,
                                    const PointSource& points, std::uint64_t samples_per_patch, Allocation allocation,
                                    StreamKey key, std::uint32_t trial);

/// The same of one trial of `area_kernel` with these arguments: the sums over pairs of patches that it adds up to
/// faces, equal to it but for rounding. Some 100 bytes for each pair of patches.
Eigen::MatrixXd kernel_patch_factors(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                     PointMap map, StreamKey key, std::uint32_t trial);

/// The exact ones: closed forms of rectangles along the axes, contour integrals of other parallelograms; in a box with
/// mirrors by images. Empty of scenes with other shapes, where something may stand in between, and where images are not
/// known.
std::optional<Eigen::MatrixXd> exact_patch_factors(const Scene& scene, Subdivision subdivision);
bool has_exact_patch_factors(const Scene& scene);

/// Area of every patch.
Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision);

/// Which patches lie in front of each other, or of an image of each other, whatever stands between them.
Sight patch_sight(const Scene& scene, Subdivision subdivision);

}  // namespace ff

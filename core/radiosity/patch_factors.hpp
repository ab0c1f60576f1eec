#pragma once

#include "core/estimators/estimator.hpp"
#include "core/estimators/rays/ray_shooting.hpp"
#include "core/geometry/subdivision.hpp"
#include "core/points/points.hpp"
#include "core/radiosity/repair.hpp"
#include "core/tracing/tracer.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>

namespace ff {

/// Number of patches on surfaces that belong to a face: the rows and columns of matrices between patches, in the order
/// of PatchOrder.
std::uint32_t radiating_patches(const Scene& scene, Subdivision subdivision);

/// Form factors from every patch to every patch, from one trial of ray shooting: the same rays as `ray_shooting` with
/// these arguments, counted by the patches that they hit. Rows sum to 1 except for lost rays. Takes 8 bytes per pair of
/// patches.
Eigen::MatrixXd shoot_patch_factors(const Scene& scene, Subdivision subdivision, const Tracer& tracer,
                                    const PointSource& points, std::uint64_t samples_per_patch, Allocation allocation,
                                    StreamKey key, std::uint32_t trial);

/// Form factors between patches from one trial of `area_kernel` with these arguments: its sums over pairs of patches
/// before it adds them up to faces, equal up to rounding. Takes about 100 bytes per pair of patches.
Eigen::MatrixXd kernel_patch_factors(const Scene& scene, Subdivision subdivision, const PointSource& points,
                                     PointMap map, StreamKey key, std::uint32_t trial);

/// The exact factors: closed forms for rectangles along the axes, contour integrals for other parallelograms; images in
/// a box with mirrors. Empty for scenes with other shapes, where something may stand in between, and where images are
/// unknown.
std::optional<Eigen::MatrixXd> exact_patch_factors(const Scene& scene, Subdivision subdivision);
bool has_exact_patch_factors(const Scene& scene);

Eigen::VectorXd face_areas(const Scene& scene);
/// Area of every patch.
Eigen::VectorXd patch_areas(const Scene& scene, Subdivision subdivision);

/// Which patches lie in front of each other, or of an image of each other, regardless of obstacles.
Sight patch_sight(const Scene& scene, Subdivision subdivision);

}  // namespace ff

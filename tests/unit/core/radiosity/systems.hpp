#pragma once

#include "core/radiosity/system.hpp"

#include <cstdint>

namespace ff::test {

/// The cube with exact factors, one reflectance, and light from face 6.
RadiositySystem lit_cube(double reflectance);

/// Exact factors of a box with different edges, reflectances and lights.
RadiositySystem lit_box();

/// The factors of the cube as `rays` independent rays from each face give them: rows sum to 1, pairs are not
/// reciprocal.
Eigen::MatrixXd shot_factors(std::uint64_t rays, std::uint64_t seed);

/// The factors of the upper triangle, and the lower triangle by reciprocity: rows do not sum to 1. @pre equal areas
Eigen::MatrixXd mirrored(const Eigen::MatrixXd& factors);

}  // namespace ff::test

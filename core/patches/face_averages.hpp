#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace ff {

/// Whether every face is one surface, so that all its patches have the same area and the form factors of rays are hits
/// over rays.
bool has_one_surface_a_face(const Scene& scene);

/// Parts of the grid per surface of each face, on average.
Eigen::VectorXd parts_a_surface(const Scene& scene);

/// Form factors between faces from rays of every surface: the average over the surfaces of a face, weighted by their
/// areas.
/// @param weighted  RayTally::weighted, of `rays` rays from every part of a surface's grid
Eigen::MatrixXd face_averages(const Scene& scene, std::span<const double> weighted, std::uint64_t rays);

}  // namespace ff

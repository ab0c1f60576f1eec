#pragma once

#include "core/scene.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace ff {

/// Whether every face is one surface, so that all its patches have the same area and the form factors of rays are hits
/// over rays.
bool has_one_surface_a_face(const Scene& scene);

/// Form factors between faces from the hits of patches: the average over the patches of a face, weighted by their
/// areas.
/// @param patch_hits  [patch * faces + face], of `rays` rays from every patch
Eigen::MatrixXd face_averages(const Scene& scene, Subdivision subdivision, std::span<const std::uint64_t> patch_hits,
                              std::uint64_t rays);

}  // namespace ff

#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace ff {

/// For faces with more pairs of surfaces, relative positions are not tested.
inline constexpr std::size_t most_surface_pairs = 1u << 22;

/// Whether a place lies on a surface, rim included, within `gap`.
bool lies_on(const Eigen::Vector3d& place, const Surface& surface, double gap);

/// Whether two surfaces that are not parallel planes have a line in common: an edge or part of one, an edge of one that
/// stands on the other, or, for round shapes, a rim. Symmetric. Angles below 1e-12 and gaps below 1e-12 of the
/// surfaces' size count as none. Straight edges on curved surfaces are not detected.
bool meet_along_line(const Surface& a, const Surface& b);

/// Whether both are flat and lie in parallel planes.
bool are_parallel(const Surface& a, const Surface& b);

}  // namespace ff

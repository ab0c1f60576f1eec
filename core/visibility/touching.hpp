#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace ff {

/// Two faces of more pairs of surfaces are not asked how they lie to each other.
inline constexpr std::size_t most_surface_pairs = 1u << 22;

/// Whether a place lies on a surface, rim included, but for a gap.
bool lies_on(const Eigen::Vector3d& place, const Surface& surface, double gap);

/// Whether two surfaces that are not parallel planes have a line in common: polygons an edge or part of one, or one an
/// edge that stands on the other; round shapes a rim. Symmetric. Angles below 1e-12 and gaps below 1e-12 of the
/// surfaces' size count as none. Whether a straight edge lies on a curved surface is not looked at.
bool meet_along_line(const Surface& a, const Surface& b);

/// Whether both are flat and lie in parallel planes.
bool are_parallel(const Surface& a, const Surface& b);

}  // namespace ff

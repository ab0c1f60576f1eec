#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>

namespace ff {

/// Relative positions are not tested for faces with more pairs of surfaces.
inline constexpr std::size_t most_surface_pairs = 1u << 22;

/// Whether a place lies on a surface, rim included, within `gap`.
bool lies_on(const Eigen::Vector3d& place, const Surface& surface, double gap);

/// Whether two surfaces that are not parallel planes have a line in common: an edge or part of one, an edge of one that
/// stands on the other, or, for round shapes, a rim. Symmetric. Angles below 1e-12 and gaps below 1e-12 of the
/// surfaces' size count as none. Straight edges on curved surfaces are not detected.
bool meet_along_line(const Surface& a, const Surface& b);

/// Whether both are flat and lie in parallel planes.
bool are_parallel(const Surface& a, const Surface& b);

/// How two patches touch.
enum class Contact {
    none,
    point,   ///< a corner of one lies inside the other or on its edge, but not on a corner
    vertex,  ///< a corner of each at the same place
    edge,    ///< edges of both overlap along a line
};

/// The side of a patch, 0 or 1 in one of its coordinates, at which the other is touched.
enum class Side : std::uint8_t { neither, low, high };

/// Where two patches touch: sides in the coordinates (source u, source v, target u, target v). At an edge each patch
/// has one side, at a vertex both; otherwise none.
struct Touch {
    Contact contact = Contact::none;
    std::array<Side, 4> sides{};
};

/// Gaps below 1e-12 of the two patches' size count as contact. Of several contacts an edge counts before a vertex.
/// @pre the patches are facets of a convex body or parts of them: they cannot cross each other
Touch find_touch(const Parallelogram& from, const Parallelogram& to);

/// The closest contact of surfaces of two faces that face each other; their patches have it too, for any subdivision.
/// @pre both are indices into scene.faces
Contact closest_contact(const Scene& scene, int from_face, int to_face);

}  // namespace ff

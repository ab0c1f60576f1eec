#pragma once

#include "core/geometry/scene.hpp"

#include <array>
#include <cstdint>

namespace ff {

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

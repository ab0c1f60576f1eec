#pragma once

#include "core/geometry/scene.hpp"

#include <cstddef>
#include <vector>

namespace ff {

/// A scene whose coplanar surfaces have been joined, and for each original surface the index of the one that contains
/// it.
struct JoinedSurfaces {
    Scene scene;
    std::vector<std::size_t> of;
};

/// The scene with fewer surfaces: those of one face that lie in one plane with the same normal are joined where
/// together they form a parallelogram, like the tiles of a wall or the triangles of a mesh. Two triangles share their
/// longest edge, parallelograms a whole edge. The covered area stays the same up to rounding (1e-11 of the largest
/// coordinate).
JoinedSurfaces join_level_surfaces(const Scene& scene);

}  // namespace ff

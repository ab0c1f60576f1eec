#pragma once

#include "core/geometry/scene.hpp"

#include <cstddef>
#include <vector>

namespace ff {

/// A scene whose level surfaces have been joined, and for each surface of the scene before which one it has become part
/// of.
struct JoinedSurfaces {
    Scene scene;
    std::vector<std::size_t> of;
};

/// The scene with fewer surfaces: those of one face that lie in one plane and look the same way are joined where
/// together they are a parallelogram, as the tiles of a wall or the triangles of a mesh are. Two triangles share their
/// longest edge, parallelograms a whole edge. What the scene covers stays the same but for rounding (1e-11 of its
/// largest coordinate).
JoinedSurfaces join_level_surfaces(const Scene& scene);

/// Only the scene.
Scene with_joined_surfaces(const Scene& scene);

}  // namespace ff

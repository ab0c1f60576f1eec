#pragma once

#include "core/geometry/scene.hpp"

namespace ff {

/// The scene with fewer surfaces: those of one face that lie in one plane and look the same way are joined where
/// together they are a parallelogram, as the tiles of a wall or the triangles of a mesh are. Two triangles share their
/// longest edge, parallelograms a whole edge. What the scene covers stays the same but for rounding (1e-11 of its
/// largest coordinate).
Scene with_joined_surfaces(const Scene& scene);

}  // namespace ff

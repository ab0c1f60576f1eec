#pragma once

#include <string>
#include <vector>

namespace ff::studies::meshes {

/// The bytes of a mesh file, and the names of its faces.
struct MeshSample {
    std::string name;  ///< with the extension
    std::string bytes;
    std::vector<std::string> faces;
};

/// A room of 4 x 3 x 2 whose floor and roof, south and north, and east and west are groups, in every form that the
/// project's own readers know. All contain a line and, where the format allows it, a hexahedron.
std::vector<MeshSample> mesh_samples();

}  // namespace ff::studies::meshes

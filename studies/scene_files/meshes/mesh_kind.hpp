#pragma once

#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <cstdint>
#include <string_view>

namespace ff::studies::meshes {

/// What a mesh file is by its content.
struct MeshKind {
    std::string_view name;       ///< "a PLY file"
    std::string_view extension;  ///< that its name should have
    /// Reads all bytes of the file of that name; null where another library does. @throws UserError
    SurfaceMesh (*read)(std::string_view file, std::string_view bytes) = nullptr;
};

/// As many bytes tell what a file is.
inline constexpr std::size_t bytes_that_tell = 65536;

/// Null where the content does not tell.
/// @param beginning  up to `bytes_that_tell` bytes  @param size  of the file
const MeshKind* mesh_kind(std::string_view beginning, std::uint64_t size);

/// What a file with that extension should be; null where no reader of the project's own has it.
const MeshKind* mesh_kind_named(std::string_view extension);

}  // namespace ff::studies::meshes

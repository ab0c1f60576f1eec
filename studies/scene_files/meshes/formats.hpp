#pragma once

#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <string_view>

namespace ff::studies::meshes {

/// The kind of a mesh file, by its content.
struct MeshKind {
    std::string_view name;       ///< "a PLY file"
    std::string_view extension;  ///< extension that its name should have
    /// Reads all bytes of the file with that name; null where another library reads it. @throws UserError
    SurfaceMesh (*read)(std::string_view file, std::string_view bytes) = nullptr;
};

/// Null where the content of a file does not tell.
const MeshKind* mesh_kind(std::string_view bytes);

/// The kind that a file with that extension should have; null where none of the project's own readers has it.
const MeshKind* mesh_kind_named(std::string_view extension);

// Each function reads the bytes of a file, whose name is for messages.
// @throws UserError "file: place: problem (why). Suggestion."

/// VTK's older format: polygons and unstructured grids, in text or binary. Groups are the values of the first array of
/// whole numbers or texts that differs between polygons.
SurfaceMesh read_vtk_legacy(std::string_view file, std::string_view bytes);

/// VTK's XML: the same, in text, base64 or appended bytes, compressed by zlib or not.
bool is_vtk_xml(std::string_view bytes);
SurfaceMesh read_vtk_xml(std::string_view file, std::string_view bytes);

/// gmsh's formats 2, 4.0 and 4.1, in text or binary. Groups are physical surfaces, by name, or else surfaces:
/// see GmshSurfaces.
SurfaceMesh read_gmsh(std::string_view file, std::string_view bytes);

/// STL in text or binary. Groups are the solids of a text.
bool is_stl(std::string_view bytes);
SurfaceMesh read_stl(std::string_view file, std::string_view bytes);

/// PLY in text or binary: faces and strips of triangles.
SurfaceMesh read_ply(std::string_view file, std::string_view bytes);

/// OFF in text, with places of three coordinates.
bool is_off(std::string_view bytes);
SurfaceMesh read_off(std::string_view file, std::string_view bytes);

/// Looks for features that move, pack or repeat polygons and that the library which reads glTF would silently ignore:
/// extensions, coordinates of whole numbers, and shapes that morph or have a skin.
/// @param bytes  of a .gltf or .glb file  @throws UserError "file: place: problem (why). Suggestion."
void expect_plain_gltf(std::string_view file, std::string_view bytes);

}  // namespace ff::studies::meshes

#pragma once

#include "studies/scene_files/meshes/surface_mesh.hpp"

#include <cstdint>
#include <string_view>

namespace ff::studies::meshes {

// Each reads the bytes of a file, whose name is for messages.
// @throws UserError "file: place: problem (why). Suggestion."

/// VTK's older format: polygons and unstructured grids, in text or binary. Groups are the values of the first array of
/// whole numbers or texts that differs between polygons.
bool is_vtk_legacy(std::string_view bytes);
SurfaceMesh read_vtk_legacy(std::string_view file, std::string_view bytes);

/// VTK's XML: the same, in text, base64 or appended bytes, compressed by zlib or not.
bool is_vtk_xml(std::string_view bytes);
SurfaceMesh read_vtk_xml(std::string_view file, std::string_view bytes);

/// gmsh's formats 2, 4.0 and 4.1, in text or binary. Groups are physical surfaces, by name, or else surfaces:
/// see GmshSurfaces.
bool is_gmsh(std::string_view bytes);
SurfaceMesh read_gmsh(std::string_view file, std::string_view bytes);

/// STL in text or binary. Groups are the solids of a text.
/// @param beginning  with all of the header  @param size  of the file, which tells a binary one
bool is_stl(std::string_view beginning, std::uint64_t size);
SurfaceMesh read_stl(std::string_view file, std::string_view bytes);

/// PLY in text or binary: faces and strips of triangles.
SurfaceMesh read_ply(std::string_view file, std::string_view bytes);

/// OFF in text, with places of three coordinates.
bool is_off(std::string_view bytes);
SurfaceMesh read_off(std::string_view file, std::string_view bytes);

}  // namespace ff::studies::meshes

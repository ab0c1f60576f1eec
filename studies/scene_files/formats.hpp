#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/readers/names.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace ff::studies {

/// Each function reads the text of a scene file; `name` is the file's, for messages.
/// @throws UserError "name:line: problem (why). Suggestion."
SceneWithMaterials read_toml_scene(std::string_view name, std::string_view text);
SceneWithMaterials read_obj_scene(std::string_view name, std::string_view text);
SceneWithMaterials read_vs3_scene(std::string_view name, std::string_view text);

struct ZoneScene {
    Scene scene;
    std::string zone;  ///< zone or space, as the file calls it
};

/// A zone or space of an input file of EnergyPlus, in its IDF or epJSON format.
/// @param zone  its name; empty: the only zone that there is
/// @throws UserError also where there are several zones and none is named
ZoneScene read_energyplus_scene(std::string_view name, std::string_view text, const std::string& zone);

template <>
inline constexpr auto names_of<Facing> = name_table(Named{Facing::outward, "outward"}, Named{Facing::inward, "inward"});

/// Whether a file name ends with this extension, in upper or lower case. @param extension  in lower case
bool has_extension(std::string_view name, std::string_view extension);

/// Whether a file name is that of a mesh: .stl, .ply, .off, .gltf, .glb, .vtk, .vtu, .vtp or .msh.
bool names_mesh(std::string_view name);

/// Whether a file name is that of an input file of EnergyPlus, which has zones: .idf or .epJSON.
bool names_energyplus(std::string_view name);

/// A mesh as the text of an OBJ file. Its groups are the nodes that contain polygons, by name, with `usemtl` where the
/// file names materials, or groups of cells; its content decides which format it has. @throws UserError, IoError
std::string mesh_as_obj(const std::filesystem::path& file);

/// @throws UserError where a file without the extension of a mesh contains one
void expect_no_mesh(const std::filesystem::path& file, std::string_view bytes);

}  // namespace ff::studies

#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/scene_files/scene_source.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Scenes that users write: TOML (surfaces of every shape), Wavefront OBJ, View3D's .vs3, EnergyPlus's .idf
/// and .epJSON and meshes (polygons); docs/scenes.md.

/// ".obj, .toml, .vs3, .idf, .epJSON, .stl, .ply, .off, .gltf, .glb, .vtk, .vtu, .vtp, .msh"
std::string scene_extensions_in_words();

/// The text of a scene file; a mesh is converted to OBJ. @throws UserError, IoError
std::string read_scene_file(const std::filesystem::path& file);

/// The values of the comment "faces group" of an OBJ file, which says what a face is.
inline constexpr std::array<std::string_view, 4> obj_faces{"group", "object", "material", "polygon"};
/// Which axis of an OBJ file points up, as in its comment "up y"; it becomes z.
inline constexpr std::array<std::string_view, 3> obj_axes{"x", "y", "z"};
/// A comment of OBJ files: every ray hits something.
inline constexpr std::string_view closed_scene = "closed";

/// Whether lengths of an OBJ file can be multiplied by this factor, as its comment "scale 0.001" requests: 1e-9 to 1e9.
bool is_scale(double factor);

/// The text of an OBJ file, or of a converted mesh, with such a comment.
std::string with_obj_comment(std::string_view text, std::string_view comment);

/// Whether a file of that name is read as OBJ.
bool is_read_as_obj(std::string_view name);

/// The statements of a scene file about a face besides its shape.
struct FaceMaterial {
    std::vector<std::string> names;    ///< names of its materials (usemtl), in order; a face may have several
    std::vector<double> emissivities;  ///< emissivities of its surfaces (.vs3), each different value once
};

struct SceneWithMaterials;

/// A built-in scene, or one from a file whose text is included.
/// @throws UserError "name:line: face: problem (why). Suggestion."
Scene make_scene(const SceneSource& source);
SceneWithMaterials make_scene_with_materials(const SceneSource& source);

/// The built-in scene of that name, which may have mirrors. @throws UserError
Scene make_scene(std::string_view title);

/// @throws UserError where a scene has masks, which only matrices of form factors take
void expect_no_masks(const Scene& scene);

/// Doubts about a scene.
struct SceneDoubts {
    /// Faults, with which results are not what the user meant: a closed scene leaks, coplanar faces overlap, or no face
    /// sees another but their backs do.
    std::vector<std::string> faults;
    std::vector<std::string> notes;  ///< possible misunderstandings, with what is assumed
};

/// Looks for coplanar overlaps, and shoots a few rays from both sides of each face, from at most a thousand surfaces;
/// none where there are more than 65536 surfaces.
SceneDoubts examine_scene(const Scene& scene);

/// Faults followed by notes.
std::vector<std::string> doubts_about(const Scene& scene);

}  // namespace ff::studies

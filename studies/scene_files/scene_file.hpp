#pragma once

#include "core/geometry/scene.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Scenes that users write: TOML (surfaces of every shape), Wavefront OBJ and View3D's .vs3 (polygons); docs/scenes.md.
///
/// A study names a scene file beside it. What it reads there becomes part of the study: in a spec, such a scene is the
/// name, a line break and the text of the file, so that stores need no other file and changed text is another study.

/// Whether a scene is a file: the name ends with .toml, .obj or .vs3, or the text is there.
bool names_scene_file(std::string_view scene);

/// Whether the text is there.
bool has_scene_text(std::string_view scene);

/// Name and text as one. @pre the name has no line break
std::string with_scene_text(std::string_view name, std::string_view text);

/// The text of an OBJ file with the comment that makes every polygon a face of its own.
std::string with_faces_of_polygons(std::string text);

/// The file of a scene that is one, without the mirrors behind it.
std::string scene_file(std::string_view scene);

/// Names a scene with some of its faces as mirrors: "cube mirrors:6", with '+' between faces. @pre no text
std::string with_mirrors_named(std::string_view scene, const std::vector<std::string>& faces);

/// A built-in scene, or that of a file whose text is there.
/// @throws UserError "name:line: face: problem (why). Suggestion."
Scene make_scene(std::string_view scene);

/// What speaks against a scene as it is.
struct SceneDoubts {
    /// With which results are not what was meant: a closed scene leaks, faces lie over each other in one plane, or no
    /// face sees another but their backs do.
    std::vector<std::string> faults;
    std::vector<std::string> notes;  ///< what may be meant, with what is assumed
};

/// Looks for surfaces that lie over each other, and shoots a few rays from both sides of each face, at most of a
/// thousand surfaces; of more than 65536 surfaces none.
SceneDoubts examine_scene(const Scene& scene);

/// Faults and notes together.
std::vector<std::string> doubts_about(const Scene& scene);

}  // namespace ff::studies

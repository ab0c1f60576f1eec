#pragma once

#include "app/command_line/options.hpp"
#include "core/geometry/scene.hpp"
#include "studies/scene_files/scene_source.hpp"

#include <string>
#include <vector>

namespace ff::app {

/// What the command line says of how an OBJ file or a mesh is read: options without their dashes, which are comments
/// that the file could have as well.
std::vector<std::string> said_of_mesh(const FormFactorsCommand& command);

/// The scene that a command names, with its text. @throws UserError where it names none, or an option does not fit it
studies::SceneSource read_source(const FormFactorsCommand& command);

/// @throws UserError where faces of it are mirrors
Scene scene_without_mirrors(const studies::SceneSource& source);

}  // namespace ff::app

#pragma once

#include "core/geometry/scene.hpp"

#include <string_view>

namespace ff::studies {

/// Each reads the text of a scene file; `name` is the file's, for messages.
/// @throws UserError "name:line: problem (why). Suggestion."
Scene read_toml_scene(std::string_view name, std::string_view text);
Scene read_obj_scene(std::string_view name, std::string_view text);
Scene read_vs3_scene(std::string_view name, std::string_view text);

}  // namespace ff::studies

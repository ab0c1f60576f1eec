#pragma once

#include "core/geometry/scene.hpp"

#include <string_view>

namespace ff {

/// A built-in scene by name: "cube" (the paper's, a = b = c = 6), "box:AxBxC", e.g. "box:2x1x0.5", a scene of the
/// catalogue, or one of its families, e.g. "squares_blocked:0.25".
/// @throws UserError with the known names otherwise
Scene built_in_scene(std::string_view name);

}  // namespace ff

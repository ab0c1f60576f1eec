#pragma once

#include <string_view>

namespace ff::studies::meshes {

/// Looks for what moves, packs or repeats polygons and is unknown to the library that reads glTF, which would pass over
/// it in silence: extensions, coordinates of whole numbers, and shapes that morph or have a skin.
/// @param bytes  of a .gltf or .glb file  @throws UserError "file: place: problem (why). Suggestion."
void expect_plain_gltf(std::string_view file, std::string_view bytes);

}  // namespace ff::studies::meshes

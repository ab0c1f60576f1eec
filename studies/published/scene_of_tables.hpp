#pragma once

#include "core/geometry/scene.hpp"
#include "studies/readers/json_reader.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {

/// Audits have unknowns for every pair of faces.
inline constexpr std::size_t most_faces_of_tables = 512;

/// The text of a tables file that needs no other file: where it names a scene file beside it, that file's text follows
/// the name. Columns of later values in that line move, lines do not.
/// @throws UserError, IoError
std::string with_scene_text(const std::string& text, const std::filesystem::path& file);

/// Reads the name of a scene, with its text if it is a file.
Scene read_scene_of_tables(const JsonReader& reader, const JsonValue& value, SceneSource& source);

/// The two faces of "1-6". Names may have dashes themselves; empty where no dash stands between names of faces.
/// @throws UserError where several do
std::optional<std::pair<std::string, std::string>> split_pair(std::string_view text,
                                                              const std::vector<std::string>& faces);

}  // namespace ff::studies

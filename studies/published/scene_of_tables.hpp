#pragma once

#include "core/geometry/fwd.hpp"
#include "studies/readers/json_reader.hpp"
#include "studies/scene_files/scene_file.hpp"

namespace ff::studies {

/// Reads the name of a scene, with its text if it is a file.
Scene read_scene_of_tables(const JsonReader& reader, const JsonValue& value, SceneSource& source);

}  // namespace ff::studies

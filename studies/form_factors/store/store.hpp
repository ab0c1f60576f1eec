#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/store/store.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ff::studies::form_factors {

/// A matrix with its scene and request.
struct KeptMatrix {
    /// Where the scene is from: a built-in name, or name and text of a file (studies/scene_files/scene_file.hpp).
    SceneSource source;
    Scene scene;      ///< built from `source`
    Request request;  ///< only fields that the result depends on are kept
    Matrix matrix;
    std::vector<std::string> warnings;
    Context context;
    bool was_checked = true;  ///< false for a file of an earlier version: damage may have gone unnoticed
};

/// Writes an SQLite file. @pre there is none of that name, or an empty one @throws IoError
void save_matrix(const std::filesystem::path& file, const KeptMatrix& kept);

/// Reads it. @throws UserError for a file that is something else or of another version; IoError where it is damaged or
/// cannot be read
KeptMatrix load_matrix(const std::filesystem::path& file);

}  // namespace ff::studies::form_factors

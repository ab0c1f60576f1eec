#pragma once

#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_source.hpp"
#include "studies/store/store.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ff::studies {

/// Version of the tables; docs/form-factors.md describes them.
inline constexpr int form_factor_schema_version = 3;

/// A matrix with its scene and request.
struct KeptFormFactors {
    /// Where the scene is from: a built-in name, or name and text of a file (studies/scene_files/scene_file.hpp).
    SceneSource source;
    Scene scene;                ///< built from `source`
    FormFactorRequest request;  ///< only fields that the result depends on are kept
    FormFactorMatrix matrix;
    std::vector<std::string> warnings;
    Context context;
    bool was_checked = true;  ///< false for a file of an earlier version: damage may have gone unnoticed
};

/// Writes an SQLite file. @pre there is none of that name, or an empty one @throws IoError
void save_form_factors(const std::filesystem::path& file, const KeptFormFactors& kept);

/// Reads it. @throws UserError for a file that is something else or of another version; IoError where it is damaged or
/// cannot be read
KeptFormFactors load_form_factors(const std::filesystem::path& file);

}  // namespace ff::studies

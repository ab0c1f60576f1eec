#pragma once

#include "studies/spec/spec.hpp"

#include <filesystem>

namespace ff::studies {

/// Reads the scenes and the tables file that a parsed study names, from its folder.
/// @throws IoError, UserError
void read_named_files(StudySpec& spec, const std::filesystem::path& folder);

}  // namespace ff::studies

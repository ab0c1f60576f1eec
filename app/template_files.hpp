#pragma once

#include "reports/templates.hpp"

#include <filesystem>

namespace ff::app {

/// The templates that come with the program, beside it when installed, or of its source and build tree; those of
/// `own` before them.
/// @param own  folder of the user; empty for none
/// @throws IoError where a folder cannot be read
reports::Templates find_templates(const std::filesystem::path& own);

}  // namespace ff::app

#pragma once

#include "reports/templates/templates.hpp"

#include <filesystem>
#include <string_view>

namespace ff::app {

/// The templates that come with the program, beside it when installed, or from its source and build tree; those of
/// `own` take precedence.
/// @param own  the user's folder; empty: none
/// @throws IoError where a folder cannot be read
reports::Templates find_templates(const std::filesystem::path& own);

/// A file among those of the program; empty where there is none.
std::filesystem::path find_template_file(std::string_view name);

}  // namespace ff::app

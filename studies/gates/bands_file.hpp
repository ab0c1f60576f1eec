#pragma once

#include "studies/gates/gate.hpp"

#include <filesystem>
#include <string_view>

namespace ff::studies {

/// Parses the text of a bands file (docs/gates.md); `origin` names it in messages.
/// @throws UserError "origin:line:column: problem (why). Suggestion."
GatesSpec parse_bands(std::string_view text, std::string_view origin);

/// @throws IoError, UserError
GatesSpec load_bands(const std::filesystem::path& file);

}  // namespace ff::studies

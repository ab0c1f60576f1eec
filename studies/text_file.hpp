#pragma once

#include <filesystem>
#include <string>

namespace ff::studies {

/// The text of a study or tables file. What is not UTF-8 is refused here: neither TOML, JSON nor SQLite would take it.
/// @throws IoError for a file that cannot be read, UserError at the first byte that is not UTF-8
std::string read_text_file(const std::filesystem::path& file);

}  // namespace ff::studies

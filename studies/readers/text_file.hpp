#pragma once

#include "studies/readers/file_kind.hpp"

#include <filesystem>
#include <string>

namespace ff::studies {

/// All bytes of a file. @throws IoError where it cannot be read
std::string read_bytes(const std::filesystem::path& file);

/// The text of a file of that kind, without a byte order mark.
/// @throws UserError where it is a file of another kind, or not UTF-8; IoError where it cannot be read
std::string read_text_file(const std::filesystem::path& file, FileKind wanted);
/// The same, of bytes that were read from it.
std::string checked_text(std::string bytes, const std::filesystem::path& file, FileKind wanted);

}  // namespace ff::studies

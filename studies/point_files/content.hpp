#pragma once

#include "samplers/outside/added.hpp"

#include <filesystem>
#include <string>

namespace ff::studies {

/// All bytes of a file. @throws IoError where it cannot be read, or is a folder or a device
std::string read_regular_file(const std::filesystem::path& file);

/// A hash of 16 hexadecimal digits that depends on the bytes alone: a file may be renamed.
std::string hash_of(const samplers::AddedSampler::Content& content);

/// Whether a text may be such a hash.
bool is_hash(std::string_view text);

}  // namespace ff::studies

#pragma once

#include "samplers/outside/added.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {

/// All bytes of a file. @throws IoError where it cannot be read, or is a folder or a device
std::string read_regular_file(const std::filesystem::path& file);

/// A hash of 16 hexadecimal digits that depends on the bytes alone: a file may be renamed.
std::string hash_of(const samplers::AddedSampler::Content& content);

/// Whether a text may be such a hash.
bool is_hash(std::string_view text);

/// Whether a sampler is points of a file: "file:points.npy".
bool names_point_file(std::string_view sampler);

/// Reads points of a file and adds them as a sampler.
///
/// The name is `file:PATH`, `file:PATH#RANDOMISE` or `file:PATH#RANDOMISE#HASH`, where {n} in the last part of PATH
/// stands for the number of points of a ladder of files. The returned name, with randomisation and hash, always stands
/// for the same points.
/// @param folder  base of a relative PATH
/// @param randomise  "" where the name states it, or for none
/// @throws IoError where no file can be read; UserError where it holds no points, or not those of the hash
const samplers::CatalogueEntry& load_point_file(std::string_view sampler, std::string_view randomise,
                                                const std::filesystem::path& folder);

/// The same from bytes kept in a store. @throws UserError unless they are those of the hash in `sampler`
const samplers::CatalogueEntry& restore_point_file(std::string_view sampler, samplers::AddedSampler::Content content);

}  // namespace ff::studies

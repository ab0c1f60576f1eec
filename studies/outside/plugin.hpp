#pragma once

#include "samplers/sampler.hpp"

#include <filesystem>
#include <vector>

namespace ff::studies {

/// Loads a plug-in (include/ffstudy/plugin.h) for the rest of the process, and adds its samplers. Each is found by its
/// own name, and by NAME#HASH with a hash of the file, which studies keep: a plug-in that was built again is another.
///
/// Loading a file runs what it runs when it is loaded: load what is trusted alone.
/// @param folder  that `path` is relative to
/// @throws IoError where the file cannot be read; UserError where it is no plug-in, of another version of the
/// interface,
///   has a name that is taken, or was changed since it was loaded
std::vector<const samplers::CatalogueEntry*> load_plugin(const std::filesystem::path& path,
                                                         const std::filesystem::path& folder = {});

}  // namespace ff::studies

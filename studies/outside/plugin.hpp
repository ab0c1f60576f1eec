#pragma once

#include "samplers/sampler.hpp"

#include <filesystem>
#include <vector>

namespace ff::studies {

/// Loads a plug-in (include/ffstudy/plugin.h) for the rest of the process, and adds its samplers. Each is found by its
/// own name, and by NAME#HASH with a hash of the file, which studies store: a rebuilt plug-in is a different one.
///
/// Loading a library runs its start-up code: load only what is trusted.
/// @param folder  base of a relative `path`
/// @throws IoError where the file cannot be read; UserError where it is no plug-in, of another version of the
/// interface,
///   has a name that is taken, or was changed since it was loaded
std::vector<const samplers::CatalogueEntry*> load_plugin(const std::filesystem::path& path,
                                                         const std::filesystem::path& folder = {});

}  // namespace ff::studies

#pragma once

#include <filesystem>
#include <string>

namespace ff::app {

/// Whether a file looks like what ffstudy 0.1 wrote under this name, before it kept a list of the files that it has
/// written; also for folders that were copied without the list.
bool is_of_earlier_version(const std::filesystem::path& folder, const std::string& name);

}  // namespace ff::app

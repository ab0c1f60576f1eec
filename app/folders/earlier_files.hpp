#pragma once

#include <filesystem>
#include <string>

namespace ff::app {

/// Whether a file looks like one that ffstudy 0.1 wrote under this name, before it kept a list of written files; also
/// for folders that were copied without the list.
bool is_of_earlier_version(const std::filesystem::path& folder, const std::string& name);

}  // namespace ff::app

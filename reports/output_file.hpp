#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace ff::reports {

/// Writes a file so that it is there whole or not at all: to a temporary file beside it, synchronised, renamed.
/// @throws IoError with what the system says
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// The same for a file that `write` makes itself, under the temporary name that it is given.
void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);
void write_file(const std::filesystem::path& file, std::string_view text);

}  // namespace ff::reports

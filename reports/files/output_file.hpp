#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace ff::reports {

/// Writes a file so that it is there whole or not at all: to a new temporary file beside it, synchronised, renamed.
/// @throws IoError with what the system says
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// The same for a file that `write` fills by itself: it is given the name of an empty one.
void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);
void write_file(const std::filesystem::path& file, std::string_view text);

/// What the names of temporary files begin with. One that a killed program has left can be removed once it is certain
/// that no other program is writing there.
inline constexpr std::string_view temporary_prefix = ".ffstudy-part-";

}  // namespace ff::reports

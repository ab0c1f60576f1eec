#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace ff::reports {

/// The folder that a file is in; "." for a name without one.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Says that a file cannot be written, and why. @param error  of the system; 0: unknown
/// @throws IoError
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

/// Writes a file completely or not at all: to a new temporary file beside it, synchronised, then renamed.
/// @throws IoError with the system's message
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// The same for a file that `write` fills itself: it receives the name of an empty one.
void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);
void write_file(const std::filesystem::path& file, std::string_view text);

/// Prefix of the names of temporary files. One left by a killed program can be removed once it is certain that no other
/// program is writing there.
inline constexpr std::string_view temporary_prefix = ".ffstudy-part-";

}  // namespace ff::reports

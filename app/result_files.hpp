#pragma once

#include "studies/results.hpp"
#include "studies/store.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// Formats of reports: markdown, csv, json.
std::span<const std::string_view> all_formats();

/// Before a long run: is the way free for every file that `write_results` would write?
/// @throws IoError that names what is in the way
void expect_room_for_results(const std::filesystem::path& folder);

/// Makes a folder for results, with those above it. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Writes the files of these formats into a folder, each whole or not at all.
/// @throws IoError; UserError for an unknown format
void write_results(const std::filesystem::path& folder, const studies::Store& store,
                   const studies::StudyResults& results, std::span<const std::string_view> formats);

}  // namespace ff::app

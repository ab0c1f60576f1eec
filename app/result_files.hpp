#pragma once

#include "reports/templates.hpp"
#include "studies/results.hpp"
#include "studies/store.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// What result files are made from.
struct ResultSources {
    const studies::Store& store;
    const studies::StudyResults& results;
    const reports::Templates& templates;
};

/// Formats of reports: html, markdown, csv, json.
std::span<const std::string_view> all_formats();

/// Before a long run: is the way free for every file that `write_results` would write?
/// @throws IoError that names what is in the way
void expect_room_for_results(const std::filesystem::path& folder);

/// Makes a folder for results, with those above it. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Writes the files of these formats into a folder, each whole or not at all.
/// @throws IoError; UserError for an unknown format
void write_results(const std::filesystem::path& folder, const ResultSources& sources,
                   std::span<const std::string_view> formats);

}  // namespace ff::app

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

/// A format of reports, with the files that it stands for.
struct Format {
    std::string_view name;
    std::string_view files;
};

std::vector<Format> all_formats();

/// Names of those that every run writes; the others are made on request, by `ffstudy report`.
std::span<const std::string_view> usual_formats();

/// @throws UserError for an unknown format, and for one that this machine lacks a program for
void expect_formats(std::span<const std::string_view> formats);

/// The store of a run that is named by its folder or by the store itself.
std::filesystem::path store_of(const std::filesystem::path& results);

/// Before a long run: is the way free for every file that `write_results` would write?
/// @throws IoError that names what is in the way
void expect_room_for_results(const std::filesystem::path& folder);

/// Removes every file that `write_results` writes in the usual formats. @throws IoError
void remove_results(const std::filesystem::path& folder);

/// Makes the store of a run one file, or says on stderr why it is not.
void seal(studies::Store& store, bool quiet);

/// Makes a folder for results, with those above it. @throws IoError
void make_folder(const std::filesystem::path& folder);

/// Results of a store. A signal ends the evaluation of systems between patches in order, and at once anything else.
/// @return whether it went to the end: where not, that is said on stderr
struct Evaluated {
    studies::StudyResults results;
    bool to_the_end = true;
};
Evaluated evaluate_until_stopped(const studies::Store& store);

/// Writes the files of these formats into a folder, each whole or not at all.
/// @throws IoError; UserError for an unknown format
void write_results(const std::filesystem::path& folder, const ResultSources& sources,
                   std::span<const std::string_view> formats);

}  // namespace ff::app

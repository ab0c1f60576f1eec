#pragma once

#include "app/folders/output_folder.hpp"

#include "reports/pictures/pictures.hpp"
#include "reports/templates/templates.hpp"
#include "studies/results/results.hpp"
#include "studies/store/store.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// The inputs of result files.
struct ResultSources {
    const studies::Store& store;
    const studies::StudyResults& results;
    const reports::Templates& templates;
    std::vector<std::string> pictures = {};  ///< pictures drawn as files: names or their beginnings; empty: all
    bool quiet = false;                      ///< show no progress
};

/// The pictures to draw as files. @throws UserError for an unknown name
std::vector<reports::Picture> chosen_pictures(const studies::StudyResults& results,
                                              const std::vector<std::string>& names);

/// A format of reports, with its files.
struct Format {
    std::string_view name;
    std::string_view files;
};

std::vector<Format> all_formats();

/// Names of the formats that every run writes; the others are made on request, by `ffstudy report`.
inline constexpr std::array<std::string_view, 4> usual_formats{"html", "markdown", "csv", "json"};

/// @throws UserError for an unknown format, and for one that this machine lacks a program for
void expect_formats(std::span<const std::string_view> formats);

/// Whether a text names the folder of a study that was begun. The folder has all that the study needs, except programs
/// and plug-ins.
bool is_folder_of_study(const std::filesystem::path& study);

/// The store of a run, given as its folder or as the store itself.
std::filesystem::path store_of(const std::filesystem::path& results);

/// Opens the store of a run to read; warns where it has no checksums. @throws UserError, IoError
studies::Store open_results(const std::filesystem::path& results);

/// Every file that `write_results` may write in the usual formats.
std::vector<std::string> usual_files();

/// Identifies the results of a study in a folder.
std::string owner_of(const studies::StudySpec& spec);

/// The store of a folder, after checking that its reports may be written too. @throws UserError, IoError
studies::Store open_or_create(OutputFolder& out, const studies::StudyPlan& plan);

/// Warns that a store has no checksums.
void note_unchecked(const std::filesystem::path& file);

/// Turns the store of a run into a single file, or says on stderr why it could not.
void seal(studies::Store& store, bool quiet);

/// Results of a store. A signal ends the evaluation of systems between patches gracefully, and anything else at once.
/// @return whether it was completed; if not, stderr says so
struct Evaluated {
    studies::StudyResults results;
    bool to_the_end = true;
};
Evaluated evaluate_until_stopped(const studies::Store& store, bool quiet);

/// Writes the files of these formats into a folder, each completely or not at all.
/// @throws IoError; UserError for an unknown format
void write_results(OutputFolder& folder, const ResultSources& sources, std::span<const std::string_view> formats);

}  // namespace ff::app

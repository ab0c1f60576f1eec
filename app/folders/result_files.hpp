#pragma once

#include "app/folders/output_folder.hpp"

#include "reports/templates/templates.hpp"
#include "studies/results/results.hpp"
#include "studies/store/store.hpp"

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

/// Whether a text names the folder of a study that was begun. It has all that the study needs but programs and
/// plug-ins.
bool is_folder_of_study(const std::filesystem::path& study);

/// The store of a run that is named by its folder or by the store itself.
std::filesystem::path store_of(const std::filesystem::path& results);

/// Every file that `write_results` may write in the usual formats.
std::vector<std::string> usual_files();

/// What the results of a study are told from those of others by, in a folder.
std::string owner_of(const studies::StudySpec& spec);

/// The store of a folder, once it is certain that its reports may be written too. @throws UserError, IoError
studies::Store open_or_create(OutputFolder& out, const studies::StudyPlan& plan);

/// Says that a store has no checksums.
void note_unchecked(const std::filesystem::path& file);

/// Makes the store of a run one file, or says on stderr why it is not.
void seal(studies::Store& store, bool quiet);

/// Results of a store. A signal ends the evaluation of systems between patches in order, and at once anything else.
/// @return whether it went to the end: where not, that is said on stderr
struct Evaluated {
    studies::StudyResults results;
    bool to_the_end = true;
};
Evaluated evaluate_until_stopped(const studies::Store& store);

/// Writes the files of these formats into a folder, each whole or not at all.
/// @throws IoError; UserError for an unknown format
void write_results(OutputFolder& folder, const ResultSources& sources, std::span<const std::string_view> formats);

}  // namespace ff::app

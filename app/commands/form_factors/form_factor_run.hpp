#pragma once

#include "app/commands/form_factors/form_factor_options.hpp"
#include "app/process/exit_code.hpp"

#include "studies/form_factors/store/store.hpp"

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace ff::app {

/// All form factors between the faces of a scene, with intervals; inconclusive where one misses the tolerance.
ExitCode form_factors(const FormFactorsCommand& command);

/// Form factors from the points of --from to the faces of a scene.
ExitCode sensor_factors(const FormFactorsCommand& command);

/// Samples a few rows of a matrix and prints what all would take: time, samples, memory and room on the disk.
ExitCode predict_form_factors(const studies::form_factors::KeptMatrix& kept);

/// The request and the scene of a command, read and validated. @throws UserError, IoError
studies::form_factors::KeptMatrix prepare_form_factors(const FormFactorsCommand& command);

/// The matrix that --load names, with the faults of its scene. @throws UserError, IoError
studies::form_factors::KeptMatrix load_kept_form_factors(const FormFactorsCommand& command);

/// @throws UserError where pairs were dropped: `what` needs them all
void expect_nothing_dropped(const studies::form_factors::KeptMatrix& kept, std::string_view what);

/// Finds a matrix: studies::form_factors::find_matrix, or a function that calls it.
using FindFormFactors =
    std::function<studies::form_factors::Matrix(const Scene&, const studies::form_factors::Request&)>;

/// Fills in the matrix, with notes and progress on stderr. True where a signal has ended it early.
bool compute_form_factors(const FormFactorsCommand& command, studies::form_factors::KeptMatrix& kept,
                          const FindFormFactors& find = studies::form_factors::find_matrix);

/// Options of `ffstudy merge`.
struct MergeCommand {
    std::vector<std::filesystem::path> sources;  ///< folders or stores
    std::filesystem::path out;
    bool quiet = false;
};

/// Brings the rows of shards together and writes the matrix; inconclusive where rows are missing.
ExitCode merge_form_factors(const MergeCommand& command);

}  // namespace ff::app

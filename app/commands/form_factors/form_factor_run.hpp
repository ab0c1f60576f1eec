#pragma once

#include "app/command_line/options.hpp"
#include "app/process/exit_code.hpp"

#include "studies/form_factors/store/store.hpp"

#include <functional>
#include <string_view>

namespace ff::app {

/// The request and the scene of a command, read and validated. @throws UserError, IoError
studies::form_factors::KeptMatrix prepare_form_factors(const FormFactorsCommand& command);

/// The matrix that --load names, with faults of its scene. @throws UserError, IoError
studies::form_factors::KeptMatrix load_kept_form_factors(const FormFactorsCommand& command);

/// @throws UserError where pairs were dropped: `what` needs them all
void expect_nothing_dropped(const studies::form_factors::KeptMatrix& kept, std::string_view what);

/// How a matrix is found: studies::form_factors::find_matrix, or what calls it.
using FindFormFactors =
    std::function<studies::form_factors::Matrix(const Scene&, const studies::form_factors::Request&)>;

/// Fills in the matrix, with notes and progress on stderr. True where a signal has ended it early.
bool compute_form_factors(const FormFactorsCommand& command, studies::form_factors::KeptMatrix& kept,
                          const FindFormFactors& find = studies::form_factors::find_matrix);

/// Brings the rows of shards together and writes the matrix; inconclusive where rows are missing.
ExitCode merge_form_factors(const MergeCommand& command);

}  // namespace ff::app

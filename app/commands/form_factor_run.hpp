#pragma once

#include "app/command_line/options.hpp"

#include "studies/form_factors/store.hpp"

namespace ff::app {

/// The request and the scene of a command, read and checked. @throws UserError, IoError
studies::KeptFormFactors prepare_form_factors(const FormFactorsCommand& command);

/// Fills in the matrix, with notes and progress on stderr. True where a signal has ended it early.
bool compute_form_factors(const FormFactorsCommand& command, studies::KeptFormFactors& kept);

}  // namespace ff::app

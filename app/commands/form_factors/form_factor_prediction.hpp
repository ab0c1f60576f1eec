#pragma once

#include "app/process/exit_code.hpp"

#include "studies/form_factors/store/store.hpp"

namespace ff::app {

/// Samples a few rows of a matrix and prints what all would take: time, samples, memory and room on the disk.
ExitCode predict_form_factors(const studies::form_factors::KeptMatrix& kept);

}  // namespace ff::app

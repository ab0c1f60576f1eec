#pragma once

#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// For a deterministic method that, as described, does not give its printed figures: both errors, the costs, and the
/// comparison with the best other method by our figures and by the printed ones. Empty where there is no such method.
/// @pre the study has published tables
std::string premise(const studies::StudyResults& results);

}  // namespace ff::reports

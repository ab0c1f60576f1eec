#pragma once

#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// Where a deterministic method as described does not give the figures that are printed of it: both errors, what the
/// methods cost, and what the comparison with the best other method is by ours and by the printed figures. Empty where
/// there is no such method. @pre the study has published tables
std::string premise(const studies::StudyResults& results);

}  // namespace ff::reports

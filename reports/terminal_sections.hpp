#pragma once

#include "reports/colour.hpp"
#include "studies/results.hpp"

#include <string>

namespace ff::reports {

/// Sections of what a run prints; empty where the study has nothing for them.
std::string terminal_slopes(const studies::StudyResults& results, Colour colour);

}  // namespace ff::reports

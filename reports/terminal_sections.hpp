#pragma once

#include "reports/colour.hpp"
#include "studies/results.hpp"

#include <string>

namespace ff::reports {

/// Sections of what a run prints; empty where the study has nothing for them.
std::string terminal_slopes(const studies::StudyResults& results, Colour colour);
/// Estimates beside the exact values of the catalogue.
std::string terminal_configurations(const studies::StudyResults& results, Colour colour);
/// Errors as the occluded share grows.
std::string terminal_occlusion(const studies::StudyResults& results, Colour colour);
/// Error against evaluations, drawn with letters, where a class of pairs has two ladders or more; of more than six the
/// best and the worst.
std::string terminal_plots(const studies::StudyResults& results);

}  // namespace ff::reports

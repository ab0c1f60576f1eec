#pragma once

#include "reports/text/text_style.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// Sections of what a run prints; empty where the study has nothing for them.
std::string terminal_slopes(const studies::StudyResults& results, const TextStyle& style);
/// Error against evaluations, drawn with letters, where a class of pairs has two ladders or more; of more than six the
/// best and the worst.
std::string terminal_plots(const studies::StudyResults& results, const TextStyle& style);

}  // namespace ff::reports

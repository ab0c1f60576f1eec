#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The outcome for a cell of an adaptive study, e.g. "reached: 9.7e-06 with 412 trials".
std::string until_in_words(const studies::StudySpec& spec, const studies::UntilOutcome& outcome);

/// The rule in a sentence, then one for all cells that reached it and one for each that did not; empty where the study
/// is not adaptive or not complete.
std::vector<std::string> until_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

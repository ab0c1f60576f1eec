#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The rule in a sentence, then one for all cells that reached it and one for each that did not; empty where the study
/// is not adaptive or not complete.
std::vector<std::string> until_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

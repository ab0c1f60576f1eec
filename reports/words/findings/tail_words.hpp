#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A line for each method and size whose trials seem to have infinite variance.
std::vector<std::string> heavy_tails_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

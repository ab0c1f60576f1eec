#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// "5.3 [4.1, 6.9]": how many times less variance, and its interval.
std::string factor_text(const studies::VarianceReduction& reduction);

/// Which sampler has the least variance at each size (of a ladder: at the largest) and on each class of pairs, and what
/// one sequence over all patches of a face does; empty where nothing is compared with random points.
std::vector<std::string> reductions_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

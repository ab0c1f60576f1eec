#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// "5.3 [4.1, 6.9]": the factor of variance reduction, and its interval.
std::string factor_text(const studies::VarianceReduction& reduction);

/// The samplers with the least variance, as far as they are told apart, at each size (of a ladder: at the largest) and
/// on each class of pairs, and the effect of one sequence over all patches of a face; empty where nothing is compared
/// with random points.
std::vector<std::string> reductions_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

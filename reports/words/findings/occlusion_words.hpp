#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The methods' errors with and without occlusion: a sentence for each method's slopes, then one for each series of
/// scenes with the method of smallest error. Empty without such scenes.
std::vector<std::string> occlusion_in_brief(const studies::StudyResults& results);

/// The same in one clause: in how many scenes each method has the smallest error.
std::string occlusion_clause(const studies::StudyResults& results);

/// The method with the smallest error in one series, by occluded fraction.
std::string series_in_words(const studies::StudyResults& results, const studies::OcclusionSeries& series);

}  // namespace ff::reports

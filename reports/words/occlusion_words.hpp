#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// How the methods err where nothing stands between two faces and where something does: a sentence for each method's
/// slopes, then one for each series of scenes with who has the least error. Empty without such scenes.
std::vector<std::string> occlusion_in_brief(const studies::StudyResults& results);

/// The same in one clause: in how many scenes which method has the least error.
std::string occlusion_clause(const studies::StudyResults& results);

/// Who has the least error in one series, by the share that is hidden.
std::string series_in_words(const studies::StudyResults& results, const studies::OcclusionSeries& series);

}  // namespace ff::reports

#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// How the methods err where nothing stands between two faces and where something does: a sentence for each method's
/// slopes, then one for each series of scenes with who errs least. Empty without such scenes.
std::vector<std::string> occlusion_in_brief(const studies::StudyResults& results);

/// The same in one clause: in how many scenes which method errs least.
std::string occlusion_clause(const studies::StudyResults& results);

/// Who errs least in one series, by the share that is hidden.
std::string series_in_words(const studies::StudyResults& results, const studies::OcclusionSeries& series);

}  // namespace ff::reports

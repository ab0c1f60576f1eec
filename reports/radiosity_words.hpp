#pragma once

#include "studies/results.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::reports {

/// What the errors do to the light, a sentence each; empty where the study has no [radiosity].
std::vector<std::string> radiosity_in_brief(const studies::StudyResults& results);

/// The cells that a comparison is about: those of the largest cost that several methods share; else all.
std::vector<std::size_t> lit_cells(const studies::StudyPlan& plan, std::size_t scene);

/// "0.9", or "0.998 [0.997, 0.999]": the median and the range over trials, where there are several.
std::string over_trials_text(const studies::OverTrials& range, std::size_t trials, int digits = 3);

/// Errors relative to the exact value: "1.2 %"; rounding shows as "0 %".
std::string percent(double share, int digits = 2);

/// Reflectances of a setting as text: "0.9".
std::string setting_text(const studies::StudyPlan& plan, std::size_t setting);

}  // namespace ff::reports

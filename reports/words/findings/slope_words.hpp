#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// "-0.66±0.02", half the width of its interval; "-0.25" without one; "-" without a slope.
std::string slope_text(const studies::Slope& slope);

/// The rate that theory expects: "-0.50"; "≤ -0.57" for an upper bound of the error; "-1.50 to -1.33" where logarithms
/// slow it down at the sizes of the ladder; "-" where none is known.
std::string expected_text(const studies::Slope& slope);

/// The comparison of trials and theory, e.g. "as expected", "slower than expected (p = 0.001)".
std::string finding_in_words(const studies::ClassSlopes& found);

/// Smallest and largest size of a ladder, and the number of sizes: "64 … 65536 (11)".
std::string sizes_text(const studies::StudyPlan& plan, const studies::Ladder& ladder);

/// For each class of pairs, which methods converge fastest and slowest, as far as they can be distinguished, then how
/// many rates are as expected; empty without ladders.
std::vector<std::string> slopes_in_brief(const studies::StudyResults& results);

}  // namespace ff::reports

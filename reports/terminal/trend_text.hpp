#pragma once

#include "studies/verdicts/trend.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The finding in a series: "from COMMIT on 1.02 instead of 1 (+2 %), p = 0.001", or that nothing was.
std::string trend_in_words(const studies::Trend& trend);

/// A line for each series, with a small picture of it.
std::string trend_text(const std::vector<studies::Trend>& trends, double alpha);

}  // namespace ff::reports

#pragma once

#include "studies/verdicts/trend.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// trend.html: a picture of each series over the commits, with the levels before and after each detected change.
std::string trend_html(const std::vector<studies::Trend>& trends, double alpha);

}  // namespace ff::reports

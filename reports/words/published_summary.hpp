#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// A publication in a few sentences: figures outside what a run can give, claims by verdict.
/// @param alpha  family-wise error rate of the figures of a table
std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha);

}  // namespace ff::reports

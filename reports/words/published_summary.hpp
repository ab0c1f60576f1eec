#pragma once

#include "studies/results/results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// How many of its claims hold: "The publication's claim is supported." With several, how many of each verdict.
std::string claims_sentence(const studies::PublishedResults& published);

/// A publication in a few sentences: figures outside what a run can give, claims by verdict.
/// @param alpha  family-wise error rate of the figures of a table
std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha);

}  // namespace ff::reports

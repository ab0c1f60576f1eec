#pragma once

#include "studies/results.hpp"

#include <string>

namespace ff::reports {

/// A publication in a few lines: figures outside what a trial can give, claims by verdict, contradictions.
std::string published_in_brief(const studies::PublishedResults& published);

}  // namespace ff::reports

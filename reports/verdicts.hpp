#pragma once

#include "studies/results.hpp"

#include <string>

namespace ff::reports {

/// The family-wise bias test in words, e.g. "no bias found (would detect 1.9e-04)".
std::string bias_in_words(const studies::CellFindings& found, double level);

/// The equivalence test in words, e.g. "|bias| < 2e-04 shown".
std::string equivalence_in_words(const studies::CellFindings& found);

}  // namespace ff::reports

#pragma once

#include "reports/text/table.hpp"
#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// The family-wise bias test in words, e.g. "none found (would detect 0.00019)".
std::string bias_in_words(const studies::CellFindings& found);

/// The equivalence test in words, e.g. "bias within ±0.0002 shown (even ±0.00014)".
std::string equivalence_in_words(const studies::CellFindings& found);

/// The mark for either, wherever it appears: bad where a bias is found, open where nothing is shown.
Mark bias_mark(const studies::CellFindings& found);
Mark equivalence_mark(studies::EquivalenceFinding finding);

}  // namespace ff::reports

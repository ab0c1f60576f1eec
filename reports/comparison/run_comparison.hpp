#pragma once

#include "reports/templates/templates.hpp"
#include "reports/text/colour.hpp"
#include "reports/text/table.hpp"
#include "studies/comparison/run_comparison.hpp"

#include <string>

namespace ff::reports {

/// Two runs side by side, A and B. All three are byte-identical for the same stores.

/// For the terminal: the verdict in a sentence, a row for each method, size and class of pairs, what differs in the
/// study files, and what only one has.
std::string comparison_text(const studies::RunComparison& comparison, Colour colour);

/// comparison.md
std::string comparison_markdown(const studies::RunComparison& comparison);

/// comparison.html, from comparison.mustache
std::string comparison_html(const studies::RunComparison& comparison, const Templates& templates);

/// The verdict on one method and size in words.
TableCell likeness_in_words(const studies::RunComparison& comparison, const studies::CellComparison& cell);

}  // namespace ff::reports

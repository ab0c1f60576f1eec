#pragma once

#include "reports/templates/templates.hpp"
#include "reports/text/text_table.hpp"
#include "studies/comparison/run_comparison.hpp"

#include <string>

namespace ff::reports {

/// Two runs side by side. All outputs are byte-identical for the same stores.

/// Text for the terminal: which run is better, the ratios of errors as a forest plot, a row for each method, size and
/// class of pairs, the differences of the study files, and cells of only one run.
std::string comparison_text(const studies::RunComparison& comparison, const TextStyle& style);

/// comparison.md
std::string comparison_markdown(const studies::RunComparison& comparison);

/// comparison.html, from comparison.mustache
std::string comparison_html(const studies::RunComparison& comparison, const Templates& templates);

/// The content of comparison_text, for programs.
std::string comparison_json(const studies::RunComparison& comparison);

}  // namespace ff::reports

#pragma once

#include "reports/text/text_table.hpp"
#include "reports/words/scene_reports.hpp"

#include <string>

namespace ff::reports {

/// Whether all pairs are within the tolerance; if not, which ones are outside.
std::string form_factors_verdict(const FormFactorReport& report);

/// Methods with reasons, the matrix if small, row sums, and pairs that miss the tolerance, for the terminal.
std::string form_factors_text(const FormFactorReport& report, const TextStyle& style = {});

}  // namespace ff::reports

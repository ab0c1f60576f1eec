#pragma once

#include "reports/text/text_style.hpp"
#include "reports/words/scene_reports.hpp"

#include <string>

namespace ff::reports {

/// Whether all pairs are within the tolerance; if not, which ones are outside.
std::string form_factors_verdict(const FormFactorReport& report);

/// For the terminal: methods with reasons, the matrix if small, row sums, pairs that miss the tolerance.
std::string form_factors_text(const FormFactorReport& report, const TextStyle& style = {});

}  // namespace ff::reports

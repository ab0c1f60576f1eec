#pragma once

#include "reports/text/text_style.hpp"
#include "reports/words/form_factor_warnings.hpp"

#include <string>

namespace ff::reports {

/// For the terminal: methods and why, the matrix where it is small, row sums, what misses the tolerance.
std::string form_factors_text(const FormFactorReport& report, const TextStyle& style = {});

}  // namespace ff::reports

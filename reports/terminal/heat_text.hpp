#pragma once

#include "reports/text/text_style.hpp"
#include "reports/words/heat_report.hpp"

#include <string>

namespace ff::reports {

/// For the terminal: a row per face, the balance, how sure it is.
std::string heat_text(const HeatReport& report, const TextStyle& style = {});

}  // namespace ff::reports

#pragma once

#include "reports/words/heat_report.hpp"

#include <string>

namespace ff::reports {

/// For the terminal: a row per face, the balance, how sure it is.
std::string heat_text(const HeatReport& report);

}  // namespace ff::reports

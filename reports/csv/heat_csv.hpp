#pragma once

#include "reports/words/heat_report.hpp"

#include <ostream>

namespace ff::reports {

/// A row per face, each quantity with `_low` and `_high`.
void write_heat_csv(std::ostream& out, const HeatReport& report);

}  // namespace ff::reports

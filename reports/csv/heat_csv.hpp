#pragma once

#include "reports/words/heat_report.hpp"

#include <ostream>

namespace ff::reports {

/// A row per face, each quantity with `_low` and `_high`.
void write_heat_csv(std::ostream& out, const HeatReport& report);

/// A row for each ordered pair; an empty `to` stands for the surroundings.
void write_gebhart_csv(std::ostream& out, const Scene& scene, const std::vector<studies::heat::GebhartFactor>& factors);

}  // namespace ff::reports

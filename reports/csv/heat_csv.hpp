#pragma once

#include "reports/words/heat_words.hpp"

#include <ostream>
#include <vector>

namespace ff::reports {

/// A row per face, of every case; each quantity with `_low` and `_high`.
void write_heat_csv(std::ostream& out, const HeatReport& report);

/// A row for each group of faces of every case.
void write_groups_csv(std::ostream& out, const HeatReport& report);

/// A row for each ordered pair; an empty `to` stands for the surroundings.
void write_gebhart_csv(std::ostream& out, const Scene& scene, const std::vector<studies::heat::GebhartFactor>& factors);

}  // namespace ff::reports

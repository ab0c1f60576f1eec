#pragma once

#include "reports/words/scene_reports.hpp"

#include <ostream>

namespace ff::reports {

/// matrix.csv: a row for each ordered pair of faces that is not 0 by geometry.
void write_form_factors_csv(std::ostream& out, const FormFactorReport& report);

/// A row per face, each quantity with `_low` and `_high`.
void write_heat_csv(std::ostream& out, const HeatReport& report);

/// A row for each ordered pair; an empty `to` stands for the surroundings.
void write_gebhart_csv(std::ostream& out, const Scene& scene, const std::vector<studies::heat::GebhartFactor>& factors);

}  // namespace ff::reports

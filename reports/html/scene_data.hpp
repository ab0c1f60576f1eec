#pragma once

#include "reports/words/form_factor_warnings.hpp"
#include "reports/words/heat_report.hpp"

#include <string>

namespace ff::reports {

/// The data that scene_report.js draws, as JSON: `faces` (names), `polygons` ([face, x, y, z, ..], counter-clockwise
/// from the radiating side; face -1 marks obstacles; round surfaces as facets), `quantities` of faces (`name`, `unit`,
/// `values`, `errors`: halves of intervals), and `matrix`: [column, factor, error, ..] for each row, and the `step` of
/// faces that a row and a column stand for, by the largest factor of any of them.
/// @param heat  flows computed from the factors; null: none
std::string scene_data(const FormFactorReport& report, const HeatReport* heat);

}  // namespace ff::reports

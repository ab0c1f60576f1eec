#pragma once

#include "reports/templates/templates.hpp"
#include "reports/words/heat_words.hpp"
#include "reports/words/scene_reports.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// report.html of `form_factors` and, with flows, of `heat`: warnings, the certainty, the scene to rotate and click, a
/// table of faces, the matrix as a heat map. One file that needs no network.
/// @param heat  flows computed from the factors; null: none @param program that made it
/// @throws UserError where a template is missing
std::string scene_html(const FormFactorReport& report, const std::vector<std::string>& warnings, const HeatReport* heat,
                       const std::string& program, const Templates& templates);

}  // namespace ff::reports

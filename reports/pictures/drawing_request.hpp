#pragma once

#include "reports/pictures/pictures.hpp"
#include "reports/templates/templates.hpp"

#include <string>

namespace ff::reports {

/// What draw_svg.mjs reads to draw every picture of a report: JSON of `kinds` (specifications by name) and `pictures`
/// (`id`, `kind`, `values`).
std::string drawing_request(const studies::StudyResults& results, const Templates& templates);

}  // namespace ff::reports

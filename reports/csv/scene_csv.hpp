#pragma once

#include "reports/words/scene_reports.hpp"

#include <ostream>

namespace ff::reports {

/// matrix.csv: a row for each ordered pair of faces that is not 0 by geometry.
void write_form_factors_csv(std::ostream& out, const FormFactorReport& report);

}  // namespace ff::reports

#pragma once

#include "reports/words/scene_reports.hpp"

#include <string>

namespace ff::reports {

/// form_factors.json; docs/form-factors.md describes the keys.
std::string form_factors_json(const FormFactorReport& report);

}  // namespace ff::reports

#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// One object per ladder; docs/results.md has its keys.
Json slopes_json(const studies::StudyResults& results);

}  // namespace ff::reports

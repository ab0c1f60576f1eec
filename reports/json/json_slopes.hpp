#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// A record of results.json and of slopes.csv; docs/results.md has its keys.
Json slope_json(const Scene& scene, const studies::Slope& slope);

/// One object per ladder; docs/results.md has its keys.
Json slopes_json(const studies::StudyResults& results);

}  // namespace ff::reports

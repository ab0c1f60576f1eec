#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Lists of objects; docs/results.md has their keys.
Json until_json(const studies::StudyResults& results);
Json heavy_tails_json(const studies::StudyResults& results);
Json coverage_json(const studies::StudyResults& results);
Json reductions_json(const studies::StudyResults& results);

}  // namespace ff::reports

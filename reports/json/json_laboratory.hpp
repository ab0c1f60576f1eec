#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Lists of objects; docs/results.md has their keys.
Json until_json(const studies::StudyResults& results);
Json heavy_tails_json(const studies::StudyResults& results);
Json coverage_json(const studies::StudyResults& results);
Json reductions_json(const studies::StudyResults& results);
/// Those at equal evaluations and at equal error; equal processor time differs from run to run.
Json contests_json(const studies::StudyResults& results);
Json claimed_errors_json(const studies::StudyResults& results);

}  // namespace ff::reports

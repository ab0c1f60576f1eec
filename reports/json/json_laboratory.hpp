#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// Whether measured times, which differ from run to run, are shown, or what does not.
enum class Timed { no, yes };

/// Lists of objects; docs/results.md has their keys.
Json until_json(const studies::StudyResults& results);
Json heavy_tails_json(const studies::StudyResults& results);
Json coverage_json(const studies::StudyResults& results);
Json reductions_json(const studies::StudyResults& results);
/// Those at equal processor time, or those at equal evaluations and at equal error.
Json contests_json(const studies::StudyResults& results, Timed timed);
Json claimed_errors_json(const studies::StudyResults& results);

}  // namespace ff::reports

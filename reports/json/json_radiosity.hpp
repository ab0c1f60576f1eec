#pragma once

#include "reports/json/json_values.hpp"
#include "studies/results/results.hpp"

namespace ff::reports {

/// The object at `radiosity`, or null; docs/results.md has its keys.
Json radiosity_json(const studies::StudyResults& results);

}  // namespace ff::reports

#pragma once

#include "reports/json/json_values.hpp"
#include "studies/verdicts/gate_result.hpp"

namespace ff::reports {

/// A record of verdicts.json and of verdicts.csv (docs/gates.md).
Json comparison_json(const studies::gates::Comparison& c);

}  // namespace ff::reports

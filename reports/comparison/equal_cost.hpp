#pragma once

#include "reports/text/json_values.hpp"
#include "reports/text/table.hpp"
#include "studies/comparison/run_comparison.hpp"

namespace ff::reports {

/// The most informative bouts of two methods: which has the smaller error at equal cost. No rows where whole runs are
/// compared.
Table equal_cost_table(const studies::RunComparison& comparison);

/// All bouts, for programs.
Json equal_cost_json(const studies::RunComparison& comparison);

}  // namespace ff::reports

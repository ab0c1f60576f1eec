#pragma once

#include "app/folders/output_folder.hpp"

#include "reports/json/gates_junit.hpp"
#include "studies/verdicts/check_results.hpp"

namespace ff::app {

/// Writes verdicts.csv, verdicts.json, junit.xml, summary.md and summary.html of the finished gates, each completely or
/// not at all.
/// @throws IoError
void write_verdicts(OutputFolder& folder, const studies::gates::CheckResults& check,
                    const reports::JunitContext& context);

}  // namespace ff::app

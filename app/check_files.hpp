#pragma once

#include "reports/gates_junit.hpp"
#include "studies/gates/check_results.hpp"

#include <filesystem>

namespace ff::app {

/// Writes verdicts.csv, verdicts.json and junit.xml of the gates that are done, each whole or not at all.
/// @throws IoError
void write_verdicts(const std::filesystem::path& folder, const studies::CheckResults& check,
                    const reports::JunitContext& context);

}  // namespace ff::app

#pragma once

#include "studies/results/results.hpp"

#include <string>

namespace ff::reports {

/// report.md: the verdict, the published tables beside ours, claims, and every number behind them. Renders on a code
/// host. Byte-identical for the same store, except for the marked block of circumstances at the end.
std::string markdown_report(const studies::StudyResults& results);

}  // namespace ff::reports

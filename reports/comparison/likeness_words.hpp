#pragma once

#include "reports/text/table.hpp"
#include "studies/comparison/run_comparison.hpp"

namespace ff::reports {

/// The verdict on one method and size in words.
TableCell likeness_in_words(const studies::RunComparison& comparison, const studies::CellComparison& cell);

}  // namespace ff::reports

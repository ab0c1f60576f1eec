#pragma once

#include "reports/text/table.hpp"

namespace ff::reports {

/// The table without columns that say nothing: all cells are empty, a dash, or "none known". The first column stays,
/// and so do all columns of a table without rows.
Table without_idle_columns(Table table);

}  // namespace ff::reports

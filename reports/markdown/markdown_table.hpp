#pragma once

#include "reports/text/table.hpp"

#include <string>

namespace ff::reports {

/// Rows and remarks of a table for a code host; title and note are left to the caller.
std::string markdown_table(const Table& table);

/// A section of report.md: title, note, and the table; empty where there are no rows.
std::string markdown_section(const Table& table);

}  // namespace ff::reports

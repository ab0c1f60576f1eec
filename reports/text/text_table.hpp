#pragma once

#include "reports/text/table.hpp"
#include "reports/text/text_style.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::reports {

/// The columns of a table for a terminal, as wide as they have to be: titles of groups, titles, rows. Where a row is
/// wider than the terminal, the columns that do not fit continue on indented lines below it. Title, note and remarks
/// are left to the caller.
std::string text_table(const Table& table, const TextStyle& style);

}  // namespace ff::reports

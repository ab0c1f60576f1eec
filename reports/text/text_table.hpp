#pragma once

#include "reports/text/colour.hpp"
#include "reports/text/table.hpp"

#include <string>
#include <string_view>

namespace ff::reports {

/// How many characters a reader sees.
std::size_t visible_length(std::string_view utf8);

/// The columns of a table for a terminal, as wide as they have to be: titles of groups, titles, rows. Title, note and
/// remarks are left to the caller.
std::string text_table(const Table& table, Colour colour);

}  // namespace ff::reports

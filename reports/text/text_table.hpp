#pragma once

#include "reports/text/table.hpp"

#include <cstddef>
#include <limits>
#include <string>

namespace ff::reports {

/// Whether a terminal is to show colours.
enum class Colour { none, ansi };

/// The text in the colour of its mark: green good, red bad, yellow open, bold surprising.
std::string painted(const std::string& text, Mark mark, Colour colour);

/// The capabilities of a terminal. A file, as another destination, has no colours and unlimited width.
struct TextStyle {
    Colour colour = Colour::none;
    std::size_t width = std::numeric_limits<std::size_t>::max();  ///< columns

    [[nodiscard]] bool is_endless() const { return width == std::numeric_limits<std::size_t>::max(); }
};

/// The columns of a table for a terminal, as wide as they have to be: titles of groups, titles, rows. Where a row is
/// wider than the terminal, titles are folded, and the cells of columns that still do not fit follow on indented lines
/// below it, each after its title. Title, note and remarks are left to the caller.
std::string text_table(const Table& table, const TextStyle& style);

}  // namespace ff::reports

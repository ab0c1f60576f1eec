#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// The property of a cell that a reader should notice.
enum class Mark {
    none,
    misprint,    ///< the audit blames this printed figure
    surprising,  ///< a run as described does not give it
    good,
    bad,
    open,  ///< undecided
};

/// A text, which needs no mark.
struct TableCell {
    std::string text;
    Mark mark = Mark::none;

    TableCell() = default;
    template <std::convertible_to<std::string_view> Text>
    // NOLINTNEXTLINE(google-explicit-constructor): rows are lists of texts
    TableCell(const Text& words, Mark its_mark = Mark::none) : text(std::string_view(words)), mark(its_mark) {}
};

struct TableColumn {
    std::string title;
    bool number = false;     ///< right-aligned
    std::string group = {};  ///< title above those of neighbouring columns with the same group; may be empty
    bool minor = false;      ///< left out where space is short, together with all of its group
};

/// Columns without groups. A title begins with > if the column is one of numbers, and then with ~ if it is minor.
std::vector<TableColumn> columns(std::initializer_list<std::string_view> titles);

/// A table independent of format: texts, of which the first column names the row.
struct Table {
    std::string id;  ///< letters, digits, - and _
    std::string title;
    std::string note;  ///< what the columns mean; may be empty
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows = {};
    std::vector<std::string> remarks = {};  ///< sentences below it
};

/// The table without columns that say nothing: all cells are empty, a dash, 0, or "none known". The first column stays,
/// and so do all columns of a table without rows.
Table without_idle_columns(Table table);

/// The table with the columns of these titles alone, in the order of the table.
Table with_columns(Table table, std::initializer_list<std::string_view> titles);

}  // namespace ff::reports

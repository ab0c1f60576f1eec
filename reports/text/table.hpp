#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ff::reports {

/// What a reader should notice about a cell.
enum class Mark {
    none,
    misprint,    ///< the audit blames this printed figure
    surprising,  ///< a run as described does not give it
    good,
    bad,
    open,  ///< undecided
};

struct TableCell {
    std::string text;
    Mark mark = Mark::none;
};

/// A cell without a mark.
inline TableCell plain_cell(std::string text) {
    return {std::move(text), Mark::none};
}

struct TableColumn {
    std::string title;
    bool number = false;  ///< right-aligned
    std::string group;    ///< title above those of neighbouring columns with the same group; may be empty
    bool minor = false;   ///< left out where space is short, together with all of its group
};

/// A table independent of format: texts, of which the first column names the row.
struct Table {
    std::string id;  ///< letters, digits, - and _
    std::string title;
    std::string note;  ///< what the columns mean; may be empty
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows;
    std::vector<std::string> remarks;  ///< sentences below it
};

/// The table without columns that say nothing: all cells are empty, a dash, or "none known". The first column stays,
/// and so do all columns of a table without rows.
Table without_idle_columns(Table table);

}  // namespace ff::reports

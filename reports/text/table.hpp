#pragma once

#include <string>
#include <vector>

namespace ff::reports {

/// What a reader is to notice about a cell.
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

struct TableColumn {
    std::string title;
    bool number = false;  ///< set flush right
    std::string group;    ///< equal neighbours share a title above theirs; may be empty
    bool minor = false;   ///< left out where there is little room; with all of its group
};

/// A table as readers see it, whatever the format: texts, the first column naming the row.
struct Table {
    std::string id;  ///< letters, digits, - and _
    std::string title;
    std::string note;  ///< what the columns mean; may be empty
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows;
    std::vector<std::string> remarks;  ///< sentences below it
};

}  // namespace ff::reports

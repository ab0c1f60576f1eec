#include "reports/text/table.hpp"

#include "reports/text/table.hpp"

#include <algorithm>
#include <cstddef>

namespace ff::reports {

Table without_idle_columns(Table table) {
    if (table.rows.empty()) return table;
    for (std::size_t column = table.columns.size(); --column > 0;) {
        const bool idle = std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
            const std::string& text = row[column].text;
            return text.empty() || text == "–" || text == "none known";
        });
        if (!idle) continue;
        const auto at = static_cast<std::ptrdiff_t>(column);
        table.columns.erase(table.columns.begin() + at);
        for (auto& row : table.rows) row.erase(row.begin() + at);
    }
    return table;
}

Table without_idle_columns(Table table) {
    if (table.rows.empty()) return table;
    for (std::size_t column = table.columns.size(); --column > 0;) {
        const bool idle = std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
            const std::string& text = row[column].text;
            return text.empty() || text == "–" || text == "none known";
        });
        if (!idle) continue;
        const auto at = static_cast<std::ptrdiff_t>(column);
        table.columns.erase(table.columns.begin() + at);
        for (auto& row : table.rows) row.erase(row.begin() + at);
    }
    return table;
}

}  // namespace ff::reports

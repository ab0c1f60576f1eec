#include "reports/text/table.hpp"

#include <algorithm>
#include <cstddef>

namespace ff::reports {

std::vector<TableColumn> columns(std::initializer_list<std::string_view> titles) {
    std::vector<TableColumn> all;
    for (std::string_view title : titles) {
        const bool number = title.starts_with('>');
        if (number) title.remove_prefix(1);
        const bool minor = title.starts_with('~');
        if (minor) title.remove_prefix(1);
        all.push_back({std::string(title), number, {}, minor});
    }
    return all;
}

Table without_idle_columns(Table table) {
    if (table.rows.empty()) return table;
    for (std::size_t column = table.columns.size(); --column > 0;) {
        const bool idle = std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
            const std::string& text = row[column].text;
            return text.empty() || text == "–" || text == "0" || text == "none known";
        });
        if (!idle) continue;
        const auto at = static_cast<std::ptrdiff_t>(column);
        table.columns.erase(table.columns.begin() + at);
        for (auto& row : table.rows) row.erase(row.begin() + at);
    }
    return table;
}

}  // namespace ff::reports

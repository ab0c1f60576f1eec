#include "reports/text/table.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

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

namespace {

/// Removes the columns for which this does not hold, by their numbers.
template <class IsKept>
Table kept_columns(Table table, const IsKept& is_kept) {
    for (std::size_t column = table.columns.size(); column-- > 0;) {
        if (is_kept(table, column)) continue;
        const auto at = static_cast<std::ptrdiff_t>(column);
        table.columns.erase(table.columns.begin() + at);
        for (auto& row : table.rows) row.erase(row.begin() + at);
    }
    return table;
}

}  // namespace

Table without_idle_columns(Table table) {
    if (table.rows.empty()) return table;
    return kept_columns(std::move(table), [](const Table& whole, std::size_t column) {
        return column == 0 || !std::all_of(whole.rows.begin(), whole.rows.end(), [&](const auto& row) {
                   const std::string& text = row[column].text;
                   return text.empty() || text == "–" || text == "0" || text == "none known";
               });
    });
}

Table with_columns(Table table, std::initializer_list<std::string_view> titles) {
    return kept_columns(std::move(table), [&](const Table& whole, std::size_t column) {
        return std::find(titles.begin(), titles.end(), whole.columns[column].title) != titles.end();
    });
}

}  // namespace ff::reports

#include "reports/text/text_table.hpp"

#include <algorithm>
#include <vector>

namespace ff::reports {
namespace {

constexpr std::size_t gap = 2;

std::vector<std::size_t> widths_of(const Table& table) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const TableColumn& column = table.columns[i];
        std::size_t width = visible_length(column.title);
        const bool alone = (i == 0 || table.columns[i - 1].group != column.group) &&
                           (i + 1 == table.columns.size() || table.columns[i + 1].group != column.group);
        if (alone) width = std::max(width, visible_length(column.group));
        for (const auto& row : table.rows) width = std::max(width, visible_length(row[i].text));
        widths.push_back(width);
    }
    return widths;
}

/// Without blanks at the end.
std::string line_of(const Table& table, const std::vector<std::size_t>& widths, const std::vector<TableCell>& row,
                    Colour colour) {
    std::string out;
    std::size_t blanks = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t room = widths[i] - std::min(widths[i], visible_length(row[i].text));
        if (table.columns[i].number) blanks += room;
        if (!row[i].text.empty()) {
            out += std::string(blanks, ' ') + painted(row[i].text, row[i].mark, colour);
            blanks = 0;
        }
        if (!table.columns[i].number) blanks += room;
        blanks += gap;
    }
    return out + "\n";
}

}  // namespace

std::size_t visible_length(std::string_view utf8) {
    return static_cast<std::size_t>(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string text_table(const Table& table, Colour colour) {
    const auto widths = widths_of(table);
    std::vector<TableCell> groups;
    std::vector<TableCell> titles;
    bool grouped = false;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const TableColumn& column = table.columns[i];
        const bool first = i == 0 || table.columns[i - 1].group != column.group;
        groups.push_back({first ? column.group : "", Mark::none});
        titles.push_back({column.title, Mark::none});
        grouped |= !column.group.empty();
    }
    std::string out = grouped ? line_of(table, widths, groups, colour) : std::string();
    out += line_of(table, widths, titles, colour);
    for (const auto& row : table.rows) out += line_of(table, widths, row, colour);
    return out;
}

}  // namespace ff::reports

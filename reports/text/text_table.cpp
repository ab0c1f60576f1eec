#include "reports/text/text_table.hpp"

#include "core/support/words.hpp"
#include "reports/text/folding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

std::string_view code_of(Mark mark) {
    switch (mark) {
        case Mark::good:
            return "\033[32m";
        case Mark::bad:
            return "\033[31m";
        case Mark::open:
            return "\033[33m";
        case Mark::misprint:
        case Mark::surprising:
            return "\033[1m";
        case Mark::none:
            break;
    }
    return "";
}

constexpr std::size_t gap = 2;
constexpr std::size_t indent = 4;  // indentation of lines that continue a row

/// A column as it is set.
struct SetColumn {
    std::size_t width = 0;
    bool begins_line = false;
};

/// Length of the longest word.
std::size_t longest_word(std::string_view text) {
    std::size_t longest = 0;
    for (const std::string_view word : split_at(' ', text)) longest = std::max(longest, visible_length(word));
    return longest;
}

/// @param titles_fold  whether a title may have several lines, of whole words
std::size_t width_of(const Table& table, std::size_t i, bool titles_fold) {
    const TableColumn& column = table.columns[i];
    std::size_t width = titles_fold ? longest_word(column.title) : visible_length(column.title);
    const bool alone = (i == 0 || table.columns[i - 1].group != column.group) &&
                       (i + 1 == table.columns.size() || table.columns[i + 1].group != column.group);
    if (alone) width = std::max(width, visible_length(column.group));
    for (const auto& row : table.rows) width = std::max(width, visible_length(row[i].text));
    return width;
}

std::vector<SetColumn> set_columns(const Table& table, std::size_t room, bool titles_fold) {
    std::vector<SetColumn> columns;
    std::size_t end = 0;  // width of the line so far
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::size_t width = width_of(table, i, titles_fold);
        const bool begins_line = i > 0 && end + gap + width > room;
        columns.push_back({width, begins_line});
        end = (begins_line ? indent : i == 0 ? 0 : end + gap) + width;
    }
    return columns;
}

/// A row without blanks at the end of lines, and without continuing lines that would be blank.
std::string row_text(const Table& table, const std::vector<SetColumn>& columns, const std::vector<TableCell>& row,
                     const TextStyle& style) {
    std::string out;
    std::size_t blanks = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::size_t room = columns[i].width - std::min(columns[i].width, visible_length(row[i].text));
        if (columns[i].begins_line) {
            if (!out.empty() && out.back() != '\n') out += '\n';
            blanks = indent;
        }
        if (table.columns[i].number) blanks += room;
        if (!row[i].text.empty()) {
            const std::string text =
                columns[i].begins_line ? folded_line(row[i].text, indent, indent, style.width) : row[i].text;
            out += std::string(blanks, ' ') + painted(text, row[i].mark, style.colour);
            blanks = 0;
        }
        if (!table.columns[i].number) blanks += room;
        blanks += gap;
    }
    if (out.empty() || out.back() != '\n') out += '\n';
    return out;
}

/// The titles of columns, a row for each of their lines. The last lines stand on the first row of the table.
std::vector<std::vector<TableCell>> title_rows(const Table& table, const std::vector<SetColumn>& columns) {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 1;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::vector<std::string>& own = lines.emplace_back();
        for (const std::string_view word : split_at(' ', table.columns[i].title)) {
            const bool fits = !own.empty() && visible_length(own.back()) + 1 + visible_length(word) <= columns[i].width;
            if (fits)
                own.back() += fmt::format(" {}", word);
            else
                own.emplace_back(word);
        }
        height = std::max(height, own.size());
    }
    std::vector<std::vector<TableCell>> rows(height);
    for (const auto& own : lines) {
        for (std::size_t line = 0; line < height; ++line)
            rows[line].emplace_back(line + own.size() < height ? std::string() : own[line + own.size() - height]);
    }
    return rows;
}

}  // namespace

std::string painted(const std::string& text, Mark mark, Colour colour) {
    if (colour == Colour::none || mark == Mark::none || text.empty()) return text;
    return fmt::format("{}{}\033[0m", code_of(mark), text);
}

std::string text_table(const Table& table, const TextStyle& style) {
    const auto is_folded = [](const SetColumn& column) { return column.begins_line; };
    auto columns = set_columns(table, style.width, false);
    if (std::any_of(columns.begin(), columns.end(), is_folded)) columns = set_columns(table, style.width, true);
    std::vector<TableCell> groups;
    bool grouped = false;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const TableColumn& column = table.columns[i];
        const bool first = i == 0 || table.columns[i - 1].group != column.group || columns[i].begins_line;
        groups.push_back(first ? column.group : "");
        grouped |= !column.group.empty();
    }
    std::string out = grouped ? row_text(table, columns, groups, style) : std::string();
    for (const auto& titles : title_rows(table, columns)) out += row_text(table, columns, titles, style);
    for (const auto& row : table.rows) out += row_text(table, columns, row, style);
    return out;
}

}  // namespace ff::reports

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

/// The widths of the columns that fit into a line, at least of the first.
std::vector<std::size_t> widths_that_fit(const Table& table, std::size_t room, bool titles_fold) {
    std::vector<std::size_t> widths;
    std::size_t end = 0;  // width of the line so far
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::size_t width = width_of(table, i, titles_fold);
        end += (i > 0 ? gap : 0) + width;
        if (i > 0 && end > room) break;
        widths.push_back(width);
    }
    return widths;
}

/// The cells of the columns that fit into a line, without blanks at its end.
std::string line_of(const Table& table, const std::vector<std::size_t>& widths, const std::vector<TableCell>& row,
                    const TextStyle& style) {
    std::string out;
    std::size_t blanks = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::size_t room = widths[i] - std::min(widths[i], visible_length(row[i].text));
        if (table.columns[i].number) blanks += room;
        if (!row[i].text.empty()) {
            out += std::string(blanks, ' ') + painted(row[i].text, row[i].mark, style.colour);
            blanks = 0;
        }
        if (!table.columns[i].number) blanks += room;
        blanks += gap;
    }
    return out + '\n';
}

/// The other cells of a row, each after its title, on indented lines; empty where all are.
std::string rest_of(const Table& table, std::size_t first, const std::vector<TableCell>& row, const TextStyle& style) {
    std::string rest;
    for (std::size_t i = first; i < row.size(); ++i) {
        if (row[i].text.empty()) continue;
        const TableColumn& column = table.columns[i];
        rest += fmt::format("{}{}{}{}: {}", rest.empty() ? "" : "; ", column.group, column.group.empty() ? "" : " ",
                            column.title, painted(row[i].text, row[i].mark, style.colour));
    }
    return rest.empty() ? rest : std::string(indent, ' ') + folded_line(rest, indent, indent, style.width) + '\n';
}

/// The titles of columns, a row for each of their lines. The last lines stand on the first row of the table.
std::vector<std::vector<TableCell>> title_rows(const Table& table, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 1;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        std::vector<std::string>& own = lines.emplace_back();
        for (const std::string_view word : split_at(' ', table.columns[i].title)) {
            const bool fits = !own.empty() && visible_length(own.back()) + 1 + visible_length(word) <= widths[i];
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
    auto widths = widths_that_fit(table, style.width, false);
    if (widths.size() < table.columns.size()) widths = widths_that_fit(table, style.width, true);
    std::vector<TableCell> groups;
    bool grouped = false;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const TableColumn& column = table.columns[i];
        const bool first = i == 0 || table.columns[i - 1].group != column.group;
        groups.push_back(first ? column.group : "");
        grouped |= !column.group.empty();
    }
    std::string out = grouped ? line_of(table, widths, groups, style) : std::string();
    for (const auto& titles : title_rows(table, widths)) out += line_of(table, widths, titles, style);
    for (const auto& row : table.rows)
        out += line_of(table, widths, row, style) + rest_of(table, widths.size(), row, style);
    return out;
}

}  // namespace ff::reports

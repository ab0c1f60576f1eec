#include "reports/markdown/markdown_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace ff::reports {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether a character belongs to a word: an underscore between two such characters is not markup. Letters beyond ASCII
/// belong to words.
bool in_word(char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a character means something to Markdown between these neighbours; 0 stands for none.
bool is_markup(char before, char c, char after) {
    switch (c) {
        case '\\':
        case '`':
        case '*':
        case '~':
            return true;
        case '_':
            return !in_word(before) || !in_word(after);
        case '<':  // begins a tag, a comment or a link
            return is_letter(after) || after == '/' || after == '!' || after == '?';
        case '&':  // begins an entity
            return is_letter(after) || after == '#';
        case ']':  // ends the text of a link: intervals are in brackets as well
            return after == '(';
        default:
            return false;
    }
}

std::string cell_text(const TableCell& cell) {
    const std::string out = markdown_cell(cell.text);
    const bool stressed = (cell.mark == Mark::bad || cell.mark == Mark::surprising) && !out.empty();
    return stressed ? fmt::format("**{}**", out) : out;
}

}  // namespace

std::string markdown_text(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char before = i == 0 ? '\0' : text[i - 1];
        const char after = i + 1 == text.size() ? '\0' : text[i + 1];
        if (is_markup(before, text[i], after)) out += '\\';
        out += text[i];
    }
    return out;
}

std::string markdown_cell(std::string_view text) {
    std::string out;
    for (const char c : markdown_text(text)) out += c == '|' ? "\\|" : std::string(1, c);
    return out;
}

std::string markdown_code(std::string_view language, std::string_view lines) {
    std::string fence = "```";
    while (lines.find(fence) != std::string_view::npos) fence += '`';
    return fmt::format("{}{}\n{}{}\n", fence, language, lines, fence);
}

std::string markdown_table(const Table& table) {
    std::string out = "|";
    std::string rule = "|";
    for (const TableColumn& column : table.columns) {
        const std::string title =
            column.group.empty() ? column.title : fmt::format("{} {}", column.group, column.title);
        out += fmt::format(" {} |", markdown_text(title));
        rule += column.number ? "--:|" : "---|";
    }
    out += "\n" + rule + "\n";
    for (const auto& row : table.rows) {
        out += "|";
        for (const TableCell& cell : row) out += fmt::format(" {} |", cell_text(cell));
        out += "\n";
    }
    for (const std::string& remark : table.remarks) out += fmt::format("\n> {}\n", markdown_text(remark));
    return out + "\n";
}

std::string folded_if_long(const std::string& table, std::size_t rows) {
    constexpr std::size_t most_rows = 40;
    return rows <= most_rows ? table
                             : fmt::format("<details><summary>{} rows</summary>\n\n{}</details>\n\n", rows, table);
}

std::string markdown_section(const Table& table) {
    if (table.rows.empty()) return {};
    return fmt::format("## {}\n\n{}\n\n{}", table.title, table.note,
                       folded_if_long(markdown_table(table), table.rows.size()));
}

}  // namespace ff::reports

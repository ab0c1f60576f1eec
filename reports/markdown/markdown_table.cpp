#include "reports/markdown/markdown_table.hpp"

#include "reports/markdown/markdown_text.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string cell_text(const TableCell& cell) {
    const std::string out = markdown_cell(cell.text);
    const bool stressed = (cell.mark == Mark::bad || cell.mark == Mark::surprising) && !out.empty();
    return stressed ? fmt::format("**{}**", out) : out;
}

}  // namespace

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

std::string markdown_section(const Table& table) {
    if (table.rows.empty()) return {};
    return fmt::format("## {}\n\n{}\n\n{}", table.title, table.note, markdown_table(table));
}

}  // namespace ff::reports

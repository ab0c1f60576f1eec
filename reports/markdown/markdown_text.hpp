#pragma once

#include "reports/text/table.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::reports {

/// Text with users' names, escaped so that Markdown shows it literally: without tags, links, entities, emphasis or
/// code. Nothing is escaped needlessly, so that the source stays readable.
std::string markdown_text(std::string_view text);

/// The same for a table cell, where bars are escaped too.
std::string markdown_cell(std::string_view text);

/// Lines of code of a language. The fence is longer than any run of backticks in them.
std::string markdown_code(std::string_view language, std::string_view lines);

/// Rows and remarks of a table for a code host; title and note are left to the caller.
std::string markdown_table(const Table& table);

/// Many rows of Markdown are folded, so that the page stays readable.
std::string folded_if_long(const std::string& table, std::size_t rows);

/// A section of report.md: title, note, and the table; empty where there are no rows.
std::string markdown_section(const Table& table);

}  // namespace ff::reports

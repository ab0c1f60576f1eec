#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::studies {

/// Where the first byte is that belongs to no character of UTF-8; npos where all is UTF-8.
std::size_t find_no_utf8(std::string_view text);

/// Where the first character begins that cannot stand in a report: a control character, a separator of lines or
/// paragraphs, a mark that turns the direction of writing, or bytes that are not UTF-8. npos where there is none.
std::size_t find_unprintable(std::string_view text);

/// The text with those characters as escapes: \x1b for a byte, \u202e for others.
std::string visible_text(std::string_view text);

/// Why a title cannot stand in reports; empty where it can.
std::string_view problem_with_title(std::string_view title);

/// Why a name cannot stand in tables and file names; empty where it can.
std::string_view problem_with_name(std::string_view name);

/// The text in quotes, as TOML has it.
std::string toml_text(std::string_view text);

}  // namespace ff::studies

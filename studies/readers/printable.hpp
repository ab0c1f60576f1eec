#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Position of the first byte that is not valid UTF-8; npos where all bytes are.
std::size_t find_no_utf8(std::string_view text);

/// The text with those characters as escapes: \x1b for a byte, \u202e for others.
std::string visible_text(std::string_view text);

/// Why reports cannot contain a title; empty where they can.
std::string_view problem_with_title(std::string_view title);

/// Why tables and file names cannot contain a name; empty where they can.
std::string_view problem_with_name(std::string_view name);

/// The first names, and how many more there are: "a, b and 3 more".
std::string first_names(std::vector<std::string> names, std::size_t most);

/// The text in quotes, as TOML has it.
std::string toml_text(std::string_view text);

}  // namespace ff::studies

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::reports {

/// The number of visible characters. Colours of a terminal have none.
std::size_t visible_length(std::string_view utf8);

/// Lines that are wider than this are broken between words. What continues a line is indented like the line or, where
/// it begins with a name and two blanks or more, like what follows them. Words that are wider stay whole.
std::string folded(std::string_view text, std::size_t width);

/// The words of one line, which begins at a column and continues at another.
std::string folded_line(std::string_view words, std::size_t begin, std::size_t indent, std::size_t width);

}  // namespace ff::reports

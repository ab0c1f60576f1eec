#pragma once

#include "reports/text/text_table.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ff::app {

/// Text from users and their files, made safe for a terminal: unprintable characters as escapes, and the middle left
/// out where it is too long to read.
std::string for_message(std::string_view text);

/// A value of a message: texts through `for_message`, others unchanged.
template <class Value>
decltype(auto) shown(const Value& value) {
    if constexpr (std::is_convertible_v<const Value&, std::string_view>)
        return for_message(value);
    else
        return (value);
}

/// Prints to stderr; lines that are wider than the terminal are folded between words.
void say_folded(std::string_view text);

/// The same. A message that cannot be printed, e.g. because the disk is full, does not end a run.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
    say_folded(fmt::format(fmt::runtime(fmt::string_view(format)), shown(values)...));
}

/// --verbose: from now on `say_more` prints.
void be_verbose();
bool is_verbose();

/// Prints to stderr with --verbose only.
template <typename... T>
void say_more(fmt::format_string<T...> format, T&&... values) {
    if (is_verbose()) say(format, std::forward<T>(values)...);
}

/// Prints to stdout as it is. Once whoever reads a pipe has left, nothing is printed any more: that is no error.
/// @throws std::system_error where stdout cannot be written
void print_verbatim(std::string_view text);

/// Prints to stdout; lines that are wider than the terminal, or than COLUMNS, are folded between words.
/// @throws std::system_error
void print_folded(std::string_view text);

template <typename First, typename... More>
void print_folded(fmt::format_string<First, More...> format, First&& first, More&&... more) {
    print_folded(fmt::format(format, std::forward<First>(first), std::forward<More>(more)...));
}

/// Writes what is still buffered. @return whether all was written, or nobody reads it
bool flush_output();

/// Colours where stdout is a terminal that has them, unless NO_COLOR is set (no-color.org), and its width.
reports::TextStyle style_of_stdout();

/// Columns of the terminal behind a file descriptor; where it is not a terminal, those of COLUMNS, or unlimited.
std::size_t width_of(int descriptor);

}  // namespace ff::app

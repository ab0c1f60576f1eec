#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace ff::app {

/// Prints to stdout as it is. Once whoever reads a pipe has left, nothing is printed any more: that is no error.
/// @throws std::system_error where stdout cannot be written
void print_verbatim(std::string_view text);

/// Prints to stdout; on a terminal, lines that are wider than it are folded between words.
/// @throws std::system_error
void print_folded(std::string_view text);

template <typename First, typename... More>
void print_folded(fmt::format_string<First, More...> format, First&& first, More&&... more) {
    print_folded(fmt::format(format, std::forward<First>(first), std::forward<More>(more)...));
}

/// Writes what is still buffered. @return whether all was written, or nobody reads it
bool flush_output();

}  // namespace ff::app

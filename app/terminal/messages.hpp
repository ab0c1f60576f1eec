#pragma once

#include <fmt/format.h>

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

/// Prints to stderr. A message that cannot be printed, e.g. because the disk is full, does not end a run.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
    std::fputs(fmt::format(fmt::runtime(fmt::string_view(format)), shown(values)...).c_str(), stderr);
}

/// --verbose: from now on `say_more` prints.
void be_verbose();
bool is_verbose();

/// Prints to stderr with --verbose only.
template <typename... T>
void say_more(fmt::format_string<T...> format, T&&... values) {
    if (is_verbose()) say(format, std::forward<T>(values)...);
}

}  // namespace ff::app

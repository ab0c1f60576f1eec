#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

namespace ff::app {

/// Text that users and their files may have written, as a terminal can take it: what is not printable as escapes, and
/// the middle left out where it is too long to be read.
std::string for_message(std::string_view text);

/// A value of a message: texts as `for_message` shows them, others as they are.
template <class Value>
decltype(auto) shown(const Value& value) {
    if constexpr (std::is_convertible_v<const Value&, std::string_view>)
        return for_message(value);
    else
        return (value);
}

/// Prints to stderr. A message that cannot be printed, because the disk behind it is full, ends no run.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
    std::fputs(fmt::format(fmt::runtime(fmt::string_view(format)), shown(values)...).c_str(), stderr);
}

}  // namespace ff::app

#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <utility>

namespace ff::app {

/// Prints to stderr. A message that cannot be printed, because the disk behind it is full, ends no run.
template <typename... T>
void say(fmt::format_string<T...> format, T&&... values) {
    std::fputs(fmt::format(format, std::forward<T>(values)...).c_str(), stderr);
}

}  // namespace ff::app

#pragma once

#include "reports/text/text_style.hpp"

#include <cstddef>

namespace ff::app {

/// Colours where stdout is a terminal that has them, unless NO_COLOR is set (no-color.org), and its width.
reports::TextStyle style_of_stdout();

/// Columns of the terminal behind a file descriptor; unlimited where it is not a terminal.
std::size_t width_of(int descriptor);

}  // namespace ff::app

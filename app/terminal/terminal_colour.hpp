#pragma once

#include "reports/text/colour.hpp"

namespace ff::app {

/// Colours where stdout is a terminal that has them, unless NO_COLOR is set (no-color.org).
reports::Colour colour_of_stdout();

}  // namespace ff::app

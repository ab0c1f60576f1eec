#pragma once

#include "reports/text/table.hpp"

#include <string>

namespace ff::reports {

/// Whether a terminal is to show colours.
enum class Colour { none, ansi };

/// The text in the colour of its mark: green good, red bad, yellow open, bold surprising.
std::string painted(const std::string& text, Mark mark, Colour colour);

}  // namespace ff::reports

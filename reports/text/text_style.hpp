#pragma once

#include "reports/text/colour.hpp"

#include <cstddef>
#include <limits>

namespace ff::reports {

/// What a terminal can show. A file, which text goes to as well, has no colours and no last column.
struct TextStyle {
    Colour colour = Colour::none;
    std::size_t width = std::numeric_limits<std::size_t>::max();  ///< columns
};

}  // namespace ff::reports

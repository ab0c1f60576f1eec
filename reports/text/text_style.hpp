#pragma once

#include "reports/text/colour.hpp"

#include <cstddef>
#include <limits>

namespace ff::reports {

/// The capabilities of a terminal. A file, as another destination, has no colours and unlimited width.
struct TextStyle {
    Colour colour = Colour::none;
    std::size_t width = std::numeric_limits<std::size_t>::max();  ///< columns
};

}  // namespace ff::reports

#pragma once

namespace ff {

/// A place where a piecewise linear function changes its slope, and by how much.
struct Kink {
    long double place = 0;
    long double change = 0;
};

}  // namespace ff

#pragma once

#include <algorithm>

namespace ff::test {

/// Faces of a box, from 1: 1 and 6, 2 and 3, 4 and 5.
inline bool are_opposite(int from, int to) {
    const int lower = std::min(from, to);
    return from + to == (lower == 1 ? 7 : lower == 2 ? 5 : 9) && lower % 2 == (lower == 1 ? 1 : 0);
}

}  // namespace ff::test

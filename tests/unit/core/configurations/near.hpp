#pragma once

#include <cmath>

namespace ff::test {

/// EXPECT_NEAR compares in double; this does so in extended precision: EXPECT_PRED3(near, computed, expected, allowed).
inline bool near(long double computed, long double expected, long double allowed) {
    return std::abs(computed - expected) <= allowed;
}

}  // namespace ff::test

#pragma once

#include <cmath>
#include <numbers>

namespace ff::test {

/// Configurations are evaluated in extended precision, and so is what they are compared with.
using Real = long double;
inline constexpr Real pi = std::numbers::pi_v<Real>;

/// EXPECT_NEAR compares in double; this does so in extended precision: EXPECT_PRED3(near, computed, expected, allowed).
inline bool near(Real computed, Real expected, Real allowed) {
    return std::abs(computed - expected) <= allowed;
}

}  // namespace ff::test

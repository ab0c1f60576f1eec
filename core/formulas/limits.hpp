#pragma once

#include <cmath>

namespace ff {

/// Functions of lengths and squared lengths that are continued by their limits where formulas would divide by 0 or take
/// the logarithm of 0.

/// ln(x), and 0 for x = 0: only for factors that vanish faster than the logarithm grows.
template <class Real>
Real limited_log(Real x) {
    return x > 0 ? std::log(x) : Real{0};
}

/// x * atan(y / x), and its limit 0 for x = 0. @pre x >= 0
template <class Real>
Real x_atan(Real x, Real y) {
    return x > 0 ? x * std::atan(y / x) : Real{0};
}

}  // namespace ff

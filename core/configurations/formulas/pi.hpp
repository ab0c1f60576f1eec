#pragma once

#include <numbers>

namespace ff {

/// In the precision that the exact values of configurations are computed in.
inline constexpr long double pi = std::numbers::pi_v<long double>;

}  // namespace ff

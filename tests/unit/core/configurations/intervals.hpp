#pragma once

#include "core/formulas/rectangle_formulas.hpp"

namespace ff::test {

inline constexpr AxisInterval unit{0, 1};
inline constexpr AxisInterval three{0, 3};

}  // namespace ff::test

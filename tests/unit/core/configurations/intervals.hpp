#pragma once

#include "core/geometry/aligned_rectangle.hpp"

namespace ff::test {

inline constexpr AxisInterval unit{0, 1};
inline constexpr AxisInterval three{0, 3};

}  // namespace ff::test

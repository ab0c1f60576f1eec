#pragma once

#include "core/geometry/aligned_rectangle.hpp"

namespace ff::test {

inline constexpr Interval unit{0, 1};
inline constexpr Interval three{0, 3};

}  // namespace ff::test

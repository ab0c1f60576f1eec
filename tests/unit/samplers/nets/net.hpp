#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ff::test {

/// Points in 4-D, one vector of coordinates (times 2^32) a dimension.
using Coordinates = std::array<std::vector<std::uint32_t>, 4>;

/// The t-value of 2^m points: the least t for which each elementary interval of volume 2^(t-m), i.e. each product of
/// four binary intervals of lengths 2^-k_d with k_1 + .. + k_4 = m - t, holds exactly 2^t points. @see
/// [niederreiter1992]
unsigned net_parameter(const Coordinates& points, unsigned m);

}  // namespace ff::test

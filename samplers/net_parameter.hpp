#pragma once

#include "samplers/point_set.hpp"

#include <cstdint>
#include <optional>

namespace ff::samplers {

/// The smallest t for which a set of base^m points is a (t, m, s)-net: every elementary interval of volume base^(t - m)
/// holds base^t points [niederreiter1992]. 0 is best, m says nothing. Coordinates are cells of width 2^-32, of which
/// the centre counts; in bases other than 2 a point on the edge of an interval may fall on either side.
/// Empty where the number of points is no power of the base. @pre set < points.sets
std::optional<std::uint32_t> net_parameter(const PointSet& points, std::uint64_t set, std::uint32_t base);

}  // namespace ff::samplers
